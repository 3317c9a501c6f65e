#include "symscene/clutter/grasp_execution.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "clutter_scenes.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

constexpr float edge = 0.05F;  // of the cube [m]

/// The tool frame of a hand with its fingertips at `tips`, that approaches at an angle from
/// straight down and closes along y.
Eigen::Isometry3d tool(const Eigen::Vector3d& tips, double angle = 0.0) {
  Eigen::Isometry3d T_table_tool = Eigen::Isometry3d::Identity();
  T_table_tool.linear() = (Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()) *
                           Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()))
                              .toRotationMatrix();
  T_table_tool.translation() = tips - 0.05 * T_table_tool.linear().col(2);
  return T_table_tool;
}

class GraspExecutionTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics";
  }

  GraspOutcome grasp_cube(const Eigen::Isometry3d& T_table_tool, double mass = 0.1) {
    const ClutterObject cube = box_object("cube", {edge, edge, edge});
    const std::vector<WeighedBody> bodies{{&cube.parts, mass}};
    world_.emplace(bodies, panda_parallel_hand());
    world_->put(0, Eigen::Isometry3d(Eigen::Translation3d(0, 0, 0.5 * edge)));
    world_->advance(0.3);
    return execute_grasp(*world_, T_table_tool);
  }

  std::optional<GraspWorld> world_;
};

TEST_F(GraspExecutionTest, ACubeIsGraspedAtItsMiddleAndLifted) {
  const GraspOutcome outcome = grasp_cube(tool({0, 0, 0.01}));
  EXPECT_EQ(outcome.end, GraspEnd::success);
  EXPECT_EQ(outcome.contact, ApproachContact::none);
  EXPECT_EQ(outcome.body, std::size_t{0});
  EXPECT_NEAR(outcome.width, edge, 0.001);
  EXPECT_NEAR(outcome.short_by, 0.0, 1e-9);
  EXPECT_NEAR(world_->pose(0).translation().z(), 0.5 * edge + 0.1, 0.01);
}

TEST_F(GraspExecutionTest, BesideTheCubeNothingIsBetweenTheFingers) {
  const GraspOutcome outcome = grasp_cube(tool({0.06, 0, 0.01}));
  EXPECT_EQ(outcome.end, GraspEnd::nothing_between_fingers);
  EXPECT_LT(outcome.width, 0.008);
}

TEST_F(GraspExecutionTest, AHandThatStartsInTheCubeFails) {
  const GraspOutcome outcome = grasp_cube(tool({0, 0.04, -0.03}));
  EXPECT_EQ(outcome.end, GraspEnd::contact_at_start);
  EXPECT_EQ(outcome.contact, ApproachContact::body);
  EXPECT_EQ(outcome.body, std::size_t{0});
}

TEST_F(GraspExecutionTest, AHandThatWouldSweepThroughTheTableStopsAtIt) {
  const GraspOutcome outcome = grasp_cube(tool({0.2, 0, -0.02}));
  EXPECT_EQ(outcome.end, GraspEnd::nothing_between_fingers);
  EXPECT_EQ(outcome.contact, ApproachContact::table);
  EXPECT_GT(outcome.short_by, 0.015);
  EXPECT_GT(world_->hand_pose().translation().z(), 0.0);
}

TEST_F(GraspExecutionTest, AHandThatMeetsTheCubeOnItsWayClosesThere) {
  const GraspOutcome outcome = grasp_cube(tool({0, 0.03, 0.01}));
  EXPECT_EQ(outcome.contact, ApproachContact::body);
  EXPECT_NEAR(outcome.short_by, edge - 0.01, 0.004);
}

TEST_F(GraspExecutionTest, ASideGraspIsLiftedStraightUp) {
  const GraspOutcome outcome = grasp_cube(tool({-0.015, 0, 0.5 * edge + 0.012}, radians(-80.0)));
  ASSERT_EQ(outcome.contact, ApproachContact::none);
  EXPECT_EQ(outcome.end, GraspEnd::success);
  EXPECT_NEAR(world_->pose(0).translation().z(), 0.5 * edge + 0.1, 0.01);
  EXPECT_NEAR(world_->pose(0).translation().x(), 0.0, 0.01);
}

TEST_F(GraspExecutionTest, ACubeTooHeavyForTheFingersSlips) {
  const GraspOutcome outcome = grasp_cube(tool({0, 0, 0.01}), 8.0);
  EXPECT_EQ(outcome.end, GraspEnd::slipped);
  EXPECT_NEAR(outcome.closed_width, edge, 0.001);
}

}  // namespace
}  // namespace symscene
