#include "symscene/physics/grasp_world.hpp"

#include <gtest/gtest.h>

#include "physics/convex_shapes.hpp"
#include "symscene/core/error.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

/// The tool frame of a hand that points down, with its fingertips at this height.
Eigen::Isometry3d hand_above(double x, double y, double tips) {
  Eigen::Isometry3d T_table_tool = at(x, y, tips + 0.05);
  T_table_tool.rotate(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
  return T_table_tool;
}

class GraspWorldTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics";
  }

  /// A cube at rest on the table.
  GraspWorld world_with_cube(double mass = 0.2) const {
    const std::vector<WeighedBody> bodies{{&cube_, mass}};
    GraspWorld world(bodies, panda_parallel_hand());
    world.put(0, at(0, 0, 0.5 * cube_edge));
    world.advance(0.5);
    return world;
  }

  const ConvexParts cube_ = box(cube_edge, cube_edge, cube_edge);
};

TEST_F(GraspWorldTest, TheHandHoversOpenWhereItIsPut) {
  GraspWorld world = world_with_cube();
  world.put_hand(hand_above(0.3, 0, 0.2));
  world.advance(1.0);
  EXPECT_NEAR((world.hand_pose().translation() - Eigen::Vector3d(0.3, 0, 0.25)).norm(), 0.0, 1e-4);
  EXPECT_NEAR(world.opening(), 0.08, 1e-3);
  EXPECT_FALSE(world.hand_contacts().any());
}

TEST_F(GraspWorldTest, TheHandMovesAtTheSpeedOfItsTarget) {
  GraspWorld world = world_with_cube();
  world.put_hand(hand_above(0.3, 0, 0.2));
  for (int step = 1; step <= 50; ++step) {
    world.pull_hand_to({0.3, 0.002 * step, 0.25});
    world.advance(0.02);
  }
  EXPECT_NEAR(world.hand_pose().translation().y(), 0.1, 0.003);
  world.advance(0.1);
  EXPECT_NEAR(world.hand_pose().translation().y(), 0.1, 1e-4);
}

TEST_F(GraspWorldTest, ClosedFingersHaveTheWidthOfTheCubeBetweenThem) {
  GraspWorld world = world_with_cube();
  world.put_hand(hand_above(0, 0, 0.005));
  EXPECT_FALSE(world.hand_contacts().any());
  world.close_fingers(true);
  world.advance(0.5);
  EXPECT_NEAR(world.opening(), cube_edge, 0.001);
  EXPECT_EQ(world.hand_contacts().held, std::vector<std::size_t>{0});
}

TEST_F(GraspWorldTest, LiftsACubeOfOneKilogramButNotOfFive) {
  // Two fingers of 20 N with a coefficient of friction of 1 hold 4.1 kg.
  for (const auto& [mass, is_lifted] : {std::pair{1.0, true}, std::pair{5.0, false}}) {
    GraspWorld world = world_with_cube(mass);
    world.put_hand(hand_above(0, 0, 0.005));
    world.close_fingers(true);
    world.advance(0.5);
    for (int step = 1; step <= 50; ++step) {
      world.pull_hand_to({0, 0, 0.055 + 0.002 * step});
      world.advance(0.02);
    }
    const double rise = world.pose(0).translation().z() - 0.5 * cube_edge;
    EXPECT_EQ(rise > 0.09, is_lifted) << mass << " kg rises by " << rise;
  }
}

TEST_F(GraspWorldTest, FingersMoveTogetherSoThatACubeBesideTheMiddleIsCentred) {
  GraspWorld world = world_with_cube();
  world.put_hand(hand_above(0, 0.012, 0.005));
  world.close_fingers(true);
  world.advance(0.5);
  EXPECT_NEAR(world.pose(0).translation().y(), 0.012, 0.002);
}

TEST_F(GraspWorldTest, TheHandTouchesTheTableAndBodies) {
  GraspWorld world = world_with_cube();
  world.put_hand(hand_above(0.3, 0, -0.002));
  EXPECT_TRUE(world.hand_contacts().table);
  EXPECT_NEAR(world.hand_contacts().table_depth, 0.002, 5e-4);
  EXPECT_TRUE(world.hand_contacts().bodies.empty());
  world.put_hand(hand_above(0, 0.04, 0.005));
  EXPECT_FALSE(world.hand_contacts().table);
  EXPECT_EQ(world.hand_contacts().bodies, std::vector<std::size_t>{0});
  ASSERT_EQ(world.hand_contacts().depths.size(), 1);
  // The pad of the finger in the cube is at y = 0, the nearest side of the cube at -20 mm.
  EXPECT_NEAR(world.hand_contacts().depths.front(), 0.02, 0.001);
  EXPECT_TRUE(world.hand_contacts().held.empty());
  world.take_hand_away();
  world.advance(0.1);
  EXPECT_FALSE(world.hand_contacts().any());
}

TEST_F(GraspWorldTest, FixedBoxesAreThereWhileTheyAreShown) {
  const std::vector<WeighedBody> bodies{{&cube_, 0.2}};
  const std::vector<FixedBox> fixed{{{-0.1, -0.1, 0.0}, {0.1, 0.1, 0.1}}};
  GraspWorld world(bodies, panda_parallel_hand(), fixed);
  world.put(0, at(0, 0, 0.15));
  world.show_fixed(true);
  world.advance(1.0);
  EXPECT_NEAR(world.pose(0).translation().z(), 0.1 + 0.5 * cube_edge, 0.001);
  world.show_fixed(false);
  world.advance(1.0);
  EXPECT_NEAR(world.pose(0).translation().z(), 0.5 * cube_edge, 0.001);
}

TEST_F(GraspWorldTest, ABodyTouchesWhatItPenetrates) {
  const std::vector<WeighedBody> bodies{{&cube_, 0.2}, {&cube_, 0.2}};
  GraspWorld world(bodies, panda_parallel_hand());
  world.put(0, at(0, 0, 0.1));
  EXPECT_FALSE(world.touches(0));
  world.put(1, at(0.03, 0, 0.1));
  EXPECT_TRUE(world.touches(0));
  world.take_away(1);
  world.put(0, at(0, 0, 0.015));
  EXPECT_TRUE(world.touches(0));
}

TEST_F(GraspWorldTest, TheSameCallsGiveTheSamePosesToTheLastBit) {
  const auto lifted = [&] {
    GraspWorld world = world_with_cube();
    world.put_hand(hand_above(0.004, 0.01, 0.005));
    world.close_fingers(true);
    world.advance(0.3);
    world.pull_hand_to({0, 0, 0.1});
    world.advance(0.3);
    return world.pose(0);
  };
  EXPECT_TRUE((lifted().matrix().array() == lifted().matrix().array()).all());
}

TEST_F(GraspWorldTest, RefusesWhatCannotBe) {
  const std::vector<WeighedBody> weightless{{&cube_, 0.0}};
  EXPECT_THROW(GraspWorld(weightless, panda_parallel_hand()), InputError);
  ParallelHand hand = panda_parallel_hand();
  hand.max_opening = 0.0;
  const std::vector<WeighedBody> bodies{{&cube_, 0.1}};
  EXPECT_THROW(GraspWorld(bodies, hand), InputError);
}

}  // namespace
}  // namespace symscene
