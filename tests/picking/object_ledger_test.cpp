#include "picking/object_ledger.hpp"

#include <gtest/gtest.h>

#include "robots/solid_mesh.hpp"
#include "symscene/grasping/gripper.hpp"

namespace symscene {
namespace {

/// A box of that size whose bottom's middle is at a place on the table.
PlacedObject box_at(const std::string& name, const Eigen::Vector3d& size, double x) {
  PlacedObject placed;
  placed.object.name = name;
  placed.object.mesh = box_mesh({-0.5 * size, 0.5 * size});
  placed.T_world_object = Eigen::Translation3d(x, 0.0, 0.5 * size.z());
  return placed;
}

/// A cup-sized block, a box that only its height lets the hand close on, and a large one.
PickTable three_boxes() {
  PickTable table;
  table.tabletop.objects = {box_at("block", {0.05, 0.05, 0.08}, -0.2),
                            box_at("flat", {0.15, 0.15, 0.03}, 0.0),
                            box_at("large", {0.15, 0.15, 0.15}, 0.25)};
  return table;
}

std::vector<TriangleMesh> surfaces_of(const PickTable& table) {
  std::vector<TriangleMesh> surfaces;
  for (const PlacedObject& placed : table.tabletop.objects) surfaces.push_back(world_mesh(placed));
  return surfaces;
}

/// The robot believes in the corners of some of the objects.
TableBelief belief_in(const PickTable& table, const std::vector<std::size_t>& objects) {
  TableBelief belief;
  for (const std::size_t i : objects) {
    GraspObject object;
    object.observed.positions = world_mesh(table.tabletop.objects[i]).vertices;
    belief.scene.objects.push_back(object);
  }
  return belief;
}

TEST(ObjectLedger, CountsWhatTheHandCouldCloseOnAsItLayAndInSomePose) {
  const PickTable table = three_boxes();
  ObjectLedger ledger(table, named_gripper("panda"));
  ledger.note_in_bin(0);
  PickRun run;
  ledger.finish(run, "");
  EXPECT_EQ(run.all.placed, 3U);
  EXPECT_EQ(run.all.in_bin, 1U);
  EXPECT_EQ(run.graspable.placed, 1U);
  EXPECT_EQ(run.graspable.in_bin, 1U);
  EXPECT_EQ(run.graspable_in_some_pose.placed, 2U);
  ASSERT_EQ(run.left.size(), 2U);
  EXPECT_EQ(run.left[0].name, "flat");
  EXPECT_TRUE(run.left[0].graspable.at_all);
  EXPECT_FALSE(run.left[1].graspable.at_all);
}

TEST(ObjectLedger, TellsWhichTrueObjectIsBelievedIn) {
  const PickTable table = three_boxes();
  ObjectLedger ledger(table, named_gripper("panda"));
  const std::vector<BeliefFate> fates(2);
  ledger.note(belief_in(table, {2, 0}), fates, {0, 1, 2}, surfaces_of(table));
  EXPECT_EQ(ledger.true_object(0), std::optional<std::size_t>(2));
  EXPECT_EQ(ledger.true_object(1), std::optional<std::size_t>(0));
}

TEST(ObjectLedger, ReasonsOfObjectsThatAreLeftDependOnWhatBecameOfThem) {
  const PickTable table = three_boxes();
  ObjectLedger ledger(table, named_gripper("panda"));
  std::vector<BeliefFate> fates(1);
  fates[0].no_grasp = GraspRejection::too_wide;
  ledger.note(belief_in(table, {2}), fates, {0, 1, 2}, surfaces_of(table));
  PickAttempt dropped;
  dropped.end = AttemptEnd::dropped;
  ledger.note_attempt(dropped, 0);
  ledger.note_fallen(0);
  PickRun run;
  ledger.finish(run, "");
  ASSERT_EQ(run.left.size(), 3U);
  EXPECT_EQ(run.fallen, 1U);
  EXPECT_NE(run.left[0].reason.find(description(AttemptEnd::dropped)), std::string::npos);
  EXPECT_NE(run.left[1].reason.find("not found"), std::string::npos);
  EXPECT_NE(run.left[2].reason.find(description(GraspRejection::too_wide)), std::string::npos);
}

}  // namespace
}  // namespace symscene
