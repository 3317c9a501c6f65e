#include "symscene/robots/reachability.hpp"

#include <gtest/gtest.h>

#include "random_positions.hpp"
#include "small_robots.hpp"
#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

/// The arm of seven joints, its base turned, with a gripper at its tip.
Robot standing_robot() {
  Robot robot;
  robot.model = seven_joint_arm();
  robot.T_world_base =
      Eigen::Translation3d(-0.4, 0.1, 0.0) * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ());
  RobotArm arm;
  arm.arm = make_arm(robot.model, "arm", "link0", "link8");
  arm.gripper = "panda";
  robot.arms.push_back(arm);
  robot.home = Eigen::VectorXd::Constant(7, 0.3);
  return robot;
}

Grasp grasp_at(const Robot& robot, const Gripper& gripper, const Eigen::VectorXd& positions) {
  Grasp grasp;
  grasp.T_world_tool =
      robot.T_world_base * link_poses(robot.model, positions).back() * gripper.T_wrist_tool;
  return grasp;
}

TEST(Reach, FindsPositionsForAGraspThatTheArmHolds) {
  const Robot robot = standing_robot();
  Gripper gripper;
  gripper.T_wrist_tool.translation().z() = 0.06;
  Random random(1);
  const ArmChain chain = arm_chain(robot.model, robot.arms[0].arm);
  for (int i = 0; i < 20; ++i) {
    const Grasp grasp = grasp_at(robot, gripper, random_positions(chain, random));
    const Reach reach = reach_grasp(robot, robot.grasping_arm(), gripper, grasp);
    ASSERT_TRUE(reach.reached());
    const Grasp reached = grasp_at(robot, gripper, reach.positions);
    EXPECT_TRUE(reached.T_world_tool.isApprox(grasp.T_world_tool, 1e-5));
  }
}

TEST(Reach, SaysThatAPoseIsTooFar) {
  const Robot robot = standing_robot();
  Grasp grasp;
  grasp.T_world_tool.translation().x() = 5.0;
  const Reach reach = reach_grasp(robot, robot.arms[0], Gripper{}, grasp);
  EXPECT_EQ(reach.reason, ReachRejection::too_far);
  EXPECT_GT(reach.value, reach.bound);
}

TEST(Reach, NamesTheJointWhoseLimitsAreExceeded) {
  const RobotModel model = planar_arm();
  const Arm arm = make_arm(model, "arm", "link0", "link3");
  const Eigen::Vector2d home(0.2, 0.2);
  const auto reach = [&](const Eigen::Vector2d& q, const RobotModel& limited) {
    return reach_pose(limited, arm, link_poses(model, q).back(), home);
  };
  EXPECT_TRUE(reach({1.0, 1.0}, model).reached());
  RobotModel limited = model;
  limited.joints[1].limits.upper = 0.5;
  const Reach beyond = reach({1.0, 1.0}, limited);
  EXPECT_EQ(beyond.reason, ReachRejection::joint_limit);
  EXPECT_EQ(beyond.joint, std::size_t{1});
  EXPECT_NEAR(beyond.value, 1.0, 1e-5);
  EXPECT_EQ(beyond.bound, 0.5);
}

TEST(Reach, TellsOrientationFromPosition) {
  const RobotModel model = planar_arm();
  const Arm arm = make_arm(model, "arm", "link0", "link3");
  const Eigen::Vector2d home(0.2, 0.2);
  Eigen::Isometry3d T = link_poses(model, Eigen::Vector2d(0.4, 0.7)).back();
  T.rotate(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()));
  EXPECT_EQ(reach_pose(model, arm, T, home).reason, ReachRejection::orientation);
  // The lengths 0.3 m and 0.2 m leave a hole of radius 0.1 m.
  T.translation() = Eigen::Vector3d(0.05, 0.0, 0.0);
  EXPECT_EQ(reach_pose(model, arm, T, home).reason, ReachRejection::position);
}

TEST(Reach, KeepsTheJointsOfOtherArms) {
  const RobotModel model = planar_arm();
  const Arm arm = make_arm(model, "arm", "link1", "link3");
  const Eigen::Vector2d home(0.7, 0.2);
  const Reach reach =
      reach_pose(model, arm, link_poses(model, Eigen::Vector2d(0.7, -0.6)).back(), home);
  ASSERT_TRUE(reach.reached());
  EXPECT_EQ(reach.positions[0], 0.7);
  EXPECT_NEAR(reach.positions[1], -0.6, 1e-5);
}

ReachabilityOptions coarse() {
  ReachabilityOptions options;
  options.spacing = 0.25;
  options.directions = 2;
  options.starts = 3;
  return options;
}

TEST(ReachabilityMap, CoversTheVolumeAndEndsWhereTheArmDoes) {
  const Robot robot = standing_robot();
  const Eigen::AlignedBox3d plane(Eigen::Vector3d(-0.5, -0.5, 0.2), Eigen::Vector3d(1.5, 0.5, 0.2));
  const ReachabilityMap map = reachability_map(robot, robot.arms[0], Gripper{}, plane, coarse());
  EXPECT_EQ(map.size, (std::array<int, 3>{9, 5, 1}));
  ASSERT_EQ(map.from_above.size(), 45U);
  EXPECT_TRUE(map.point_world(8, 4, 0).isApprox(Eigen::Vector3d(1.5, 0.5, 0.2), 1e-9));
  EXPECT_EQ(map.from_above[map.index(8, 2, 0)], 0.0F);
  EXPECT_EQ(*std::max_element(map.from_above.begin(), map.from_above.end()), 1.0F);
  EXPECT_EQ(*std::max_element(map.from_side.begin(), map.from_side.end()), 1.0F);
}

TEST(ReachabilityMap, IsTheSameForAnyNumberOfThreads) {
  const Robot robot = standing_robot();
  const Eigen::AlignedBox3d plane(Eigen::Vector3d(0.0, 0.0, 0.2), Eigen::Vector3d(0.5, 0.5, 0.2));
  const auto shares = [&] {
    const auto map = reachability_map(robot, robot.arms[0], Gripper{}, plane, coarse());
    return std::make_pair(map.from_above, map.from_side);
  };
  EXPECT_EQ(testing::with_threads(1, shares), testing::with_threads(4, shares));
}

TEST(ReachabilityMap, RefusesAnEmptyOrVeryFineGrid) {
  const Robot robot = standing_robot();
  const auto map = [&](const Eigen::AlignedBox3d& volume, const ReachabilityOptions& options) {
    return reachability_map(robot, robot.arms[0], Gripper{}, volume, options);
  };
  EXPECT_THROW(map(Eigen::AlignedBox3d(), coarse()), InputError);
  ReachabilityOptions fine = coarse();
  fine.spacing = 1e-4;
  EXPECT_THROW(map({Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()}, fine), InputError);
}

}  // namespace
}  // namespace symscene
