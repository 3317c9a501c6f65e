// The parts of a robot that pages and videos draw.
#include "robots/robot_solids.hpp"

#include <gtest/gtest.h>

#include "small_arm.hpp"

namespace symscene {
namespace {

using testing::small_arm;
using testing::small_gripper;

double distance_from(const Capsule& capsule, const Eigen::Vector3d& point) {
  const Eigen::Vector3d way = capsule.end - capsule.begin;
  const double along = std::clamp((point - capsule.begin).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (point - capsule.begin - along * way).norm();
}

struct RobotSolidsTest : ::testing::Test {
  Robot robot = small_arm();
  Gripper gripper = small_gripper();
  RobotSolids solids{robot, robot.arms[0], gripper};
  Random random{7};

  RobotSolidsTest() {
    robot.T_world_base =
        Eigen::Translation3d(0.3, -0.2, 0.1) * Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ());
  }
  Eigen::VectorXd random_positions() {
    Eigen::VectorXd positions(6);
    for (double& position : positions) position = random.uniform(-2.5, 2.5);
    return positions;
  }
};

TEST_F(RobotSolidsTest, EachLinkIsWhereItsCapsuleIs) {
  for (int round = 0; round < 20; ++round) {
    const Eigen::VectorXd positions = random_positions();
    const std::vector<Eigen::Isometry3d> poses = solids.poses({positions, 0.0});
    ASSERT_EQ(poses.size(), solids.solids().size());
    const std::vector<Eigen::Isometry3d> links = link_poses(robot.model, positions);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const RobotSolid& solid = solids.solids()[k];
      if (solid.is_hand) continue;
      const std::size_t link = robot.model.link_index(solid.name);
      Capsule capsule = robot.model.links[link].capsules.at(0);
      capsule.begin = robot.T_world_base * links[link] * capsule.begin;
      capsule.end = robot.T_world_base * links[link] * capsule.end;
      for (Eigen::Index i = 0; i < solid.mesh.vertices.rows(); ++i) {
        const Eigen::Vector3d vertex = solid.mesh.vertices.row(i).transpose().cast<double>();
        EXPECT_NEAR(distance_from(capsule, poses[k] * vertex), capsule.radius, 1e-6);
      }
    }
  }
}

TEST_F(RobotSolidsTest, FingersAreAsFarApartAsTheHandIsOpenAndFollowTheTool) {
  for (const double opening : {0.0, 0.03, gripper.max_opening}) {
    const RobotState state{random_positions(), opening};
    const std::vector<Eigen::Isometry3d> poses = solids.poses(state);
    const Eigen::Isometry3d T_tool_world = solids.tool(state).inverse();
    double least = 1.0, greatest = -1.0;  // of the inner sides, along the closing direction
    for (std::size_t k = poses.size() - 2; k < poses.size(); ++k) {
      const TriangleMesh& mesh = solids.solids()[k].mesh;
      for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
        const Eigen::Vector3d vertex = mesh.vertices.row(i).transpose().cast<double>();
        const Eigen::Vector3d at = T_tool_world * poses[k] * vertex;
        if (k == poses.size() - 2) least = std::min(least, at.y());
        if (k == poses.size() - 1) greatest = std::max(greatest, at.y());
        EXPECT_LE(at.z(), gripper.finger_depth + 1e-6);
      }
    }
    EXPECT_NEAR(least - greatest, opening, 1e-6);
  }
}

}  // namespace
}  // namespace symscene
