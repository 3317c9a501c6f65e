#include "symscene/clutter/clutter_world.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "clutter_scenes.hpp"
#include "symscene/core/error.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

class ClutterWorldTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics";
  }
  const std::vector<ClutterObject> objects_ = box_objects();
};

TEST_F(ClutterWorldTest, ObjectsRestInTheCube) {
  for (const ClutterKind kind : {ClutterKind::packed, ClutterKind::pile}) {
    const ClutterWorld world(objects_, kind, 5, 3);
    ASSERT_GE(world.present().size(), 2) << to_string(kind);
    EXPECT_LE(world.present().size(), 5) << to_string(kind);
    for (const std::size_t item : world.present()) {
      const Eigen::Array3d position = world.pose(item).translation().array();
      EXPECT_TRUE((position >= 0.0).all() && (position <= clutter::size).all());
      const float low = world.surface(item).vertices.col(2).minCoeff();
      EXPECT_GT(low, clutter::table_height - 0.002);
    }
  }
}

TEST_F(ClutterWorldTest, PackedObjectsStandUprightOnTheTable) {
  const ClutterWorld world(objects_, ClutterKind::packed, 5, 1);
  for (const std::size_t item : world.present()) {
    EXPECT_GT(world.pose(item).linear()(2, 2), 0.99);
    const float low = world.surface(item).vertices.col(2).minCoeff();
    EXPECT_NEAR(low, clutter::table_height, 0.002);
  }
}

TEST_F(ClutterWorldTest, ScalesAreThoseOfTheKind) {
  for (const auto& [kind, low, high] :
       {std::tuple{ClutterKind::packed, 0.7, 0.9}, std::tuple{ClutterKind::pile, 0.8, 1.0}}) {
    const ClutterWorld world(objects_, kind, 5, 2);
    for (const ClutterItem& item : world.items()) {
      EXPECT_GE(item.scale, low);
      EXPECT_LE(item.scale, high);
    }
  }
}

TEST_F(ClutterWorldTest, TheSeedDecidesEverything) {
  const auto poses = [&](std::uint64_t seed) {
    const ClutterWorld world(objects_, ClutterKind::pile, 4, seed);
    std::vector<double> numbers;
    for (const std::size_t item : world.present()) {
      const Eigen::Matrix4d T = world.pose(item).matrix();
      numbers.insert(numbers.end(), T.data(), T.data() + T.size());
    }
    return numbers;
  };
  EXPECT_EQ(poses(7), poses(7));
  EXPECT_NE(poses(7), poses(8));
}

/// A grasp from above, across the item's x axis, the thinner one of each box.
Eigen::Isometry3d grasp_from_above(const ClutterWorld& world, std::size_t item) {
  const Eigen::Isometry3d pose = world.pose(item);
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  T_world_tool.linear() << -pose.linear().col(1), pose.linear().col(0), Eigen::Vector3d::UnitZ();
  T_world_tool.linear().col(2) = -Eigen::Vector3d::UnitZ();
  T_world_tool.linear().col(0) = T_world_tool.linear().col(1).cross(T_world_tool.linear().col(2));
  const float top = world.surface(item).vertices.col(2).maxCoeff();
  T_world_tool.translation() = pose.translation();
  T_world_tool.translation().z() = static_cast<double>(top) - 0.025 + 0.05;
  return T_world_tool;
}

TEST_F(ClutterWorldTest, AnObjectThatIsGraspedIsTakenAway) {
  ClutterWorld world(objects_, ClutterKind::packed, 1, 4);
  ASSERT_EQ(world.present().size(), 1);
  const std::size_t item = world.present().front();
  const GraspOutcome outcome = world.execute(grasp_from_above(world, item));
  EXPECT_EQ(outcome.end, GraspEnd::success) << to_string(outcome.end);
  EXPECT_TRUE(world.present().empty());
}

TEST_F(ClutterWorldTest, TheHandPenetratesTheTableAndOtherObjectsThanItsOwn) {
  ClutterWorld world(objects_, ClutterKind::packed, 1, 4);
  const std::size_t item = world.present().front();
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  T_world_tool.linear() = Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).matrix();
  T_world_tool.translation() = Eigen::Vector3d(0.6, 0.15, clutter::table_height + 0.05 - 0.004);
  EXPECT_NEAR(world.penetration(T_world_tool, item), 0.004, 5e-4);
  T_world_tool.translation() = world.pose(item).translation() + Eigen::Vector3d(0, 0, 0.02);
  EXPECT_GT(world.penetration(T_world_tool, item + 1), 0.005);
  EXPECT_LT(world.penetration(T_world_tool, item), 0.005);
  EXPECT_EQ(world.present().size(), 1);
}

TEST_F(ClutterWorldTest, ARehearsalLeavesTheWorldAsItWas) {
  ClutterWorld world(objects_, ClutterKind::packed, 1, 4);
  ASSERT_EQ(world.present().size(), 1);
  const std::size_t item = world.present().front();
  const Eigen::Isometry3d before = world.pose(item);
  const GraspOutcome outcome = world.rehearse(grasp_from_above(world, item));
  EXPECT_EQ(outcome.end, GraspEnd::success) << to_string(outcome.end);
  ASSERT_EQ(world.present().size(), 1);
  EXPECT_TRUE(world.pose(item).isApprox(before, 1e-9));
}

TEST(ClutterKinds, AreKnownByTheirNames) {
  EXPECT_EQ(parse_clutter_kind("pile"), ClutterKind::pile);
  EXPECT_EQ(parse_clutter_kind("packed"), ClutterKind::packed);
  EXPECT_THROW(parse_clutter_kind("heap"), InputError);
}

}  // namespace
}  // namespace symscene
