#include "symscene/motion/pick_survey.hpp"

#include <gtest/gtest.h>

#include "small_arm.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using testing::box_of_points;
using testing::small_arm;
using testing::small_gripper;

/// Straight down on something at (x, y), closing along y.
Grasp from_above(double x, double y, double z) {
  Grasp grasp;
  grasp.T_world_tool = Eigen::Isometry3d(Eigen::Translation3d(x, y, z)) *
                       Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX());
  grasp.opening = 0.04;
  return grasp;
}

struct PickTest : ::testing::Test {
  Robot robot = small_arm();
  Gripper gripper = small_gripper();
  GraspScene scene;

  PickTest() {
    scene.table = Plane{};
    scene.objects.push_back(box_of_points({0.04, 0.04, 0.1}, {0.45, 0.1, 0.05}));
  }
  PickResult plan(const std::vector<Grasp>& grasps, const Eigen::VectorXd& start) const {
    return plan_pick(robot, robot.arms[0], gripper, start, scene, grasps);
  }
  Eigen::Isometry3d tool_at(const Eigen::VectorXd& positions) const {
    return link_poses(robot.model, positions).back() * gripper.T_wrist_tool;
  }
};

TEST_F(PickTest, ReachesTheGraspOnAStraightLineAndRetreats) {
  const Grasp grasp = from_above(0.45, 0.1, 0.12);
  const PickResult result = plan({grasp}, robot.home);
  ASSERT_TRUE(result.motion) << (result.rejected.empty() ? result.start_contact
                                                         : result.rejected[0].detail);
  const PickMotion& motion = *result.motion;
  EXPECT_EQ(motion.to_pre_grasp.at(0.0).position, robot.home);
  const Eigen::Vector3d at = grasp.T_world_tool.translation();
  for (double t = 0.0; t < motion.approach.duration(); t += 0.02) {
    const Eigen::Vector3d tool = tool_at(motion.approach.at(t).position).translation();
    EXPECT_NEAR((tool - at).head<2>().norm(), 0.0, 1e-3);
    EXPECT_GT(tool.z(), at.z() - 1e-3);
  }
  const auto end_of = [](const TimedPath& part) { return part.at(part.duration()).position; };
  EXPECT_TRUE(end_of(motion.to_pre_grasp).isApprox(motion.approach.at(0.0).position, 1e-9));
  EXPECT_TRUE(end_of(motion.approach).isApprox(motion.retreat.at(0.0).position, 1e-9));
  const Eigen::Isometry3d reached = tool_at(end_of(motion.approach));
  EXPECT_NEAR((reached.translation() - at).norm(), 0.0, 1e-4);
  EXPECT_NEAR(reached.linear().col(2).dot(grasp.T_world_tool.linear().col(2)), 1.0, 1e-6);
  EXPECT_NEAR(std::abs(reached.linear().col(1).dot(grasp.T_world_tool.linear().col(1))), 1.0, 1e-6);
  const Eigen::Vector3d away = tool_at(end_of(motion.retreat)).translation();
  EXPECT_NEAR((away - at - Eigen::Vector3d(0.0, 0.0, gripper.retreat_distance)).norm(), 0.0, 1e-3);
}

TEST_F(PickTest, MeetsNothingOnTheWay) {
  scene.objects.push_back(box_of_points({0.05, 0.25, 0.3}, {0.35, -0.2, 0.15}));  // a wall
  Eigen::VectorXd start = robot.home;
  start[0] = -1.2;
  const PickResult result = plan({from_above(0.45, 0.1, 0.12)}, start);
  ASSERT_TRUE(result.motion) << (result.rejected.empty() ? result.start_contact
                                                         : result.rejected[0].detail);
  const MotionObstacles obstacles(scene);
  const ArmCollision arm(robot, robot.arms[0], &gripper, gripper.max_opening, obstacles, start);
  for (const JointState& state : sampled(result.motion->to_pre_grasp, 0.02)) {
    const auto met = arm.contact(state.position);
    EXPECT_TRUE(!met || met->other.distance > 0.0) << describe(*met);
  }
}

TEST_F(PickTest, SaysWhyGraspsWereNotTaken) {
  scene.objects.push_back(box_of_points({0.2, 0.2, 0.3}, {0.45, -0.3, 0.15}));
  Grasp inside = from_above(0.45, -0.3, 0.2);  // of the small box, as the grasp has it
  const PickResult result =
      plan({from_above(3.0, 0.0, 0.1), inside, from_above(0.45, 0.1, 0.12)}, robot.home);
  ASSERT_TRUE(result.motion);
  EXPECT_EQ(result.motion->grasp, 2U);
  ASSERT_EQ(result.rejected.size(), 2U);
  EXPECT_EQ(result.rejected[0].reason, PickRejection::too_far);
  EXPECT_EQ(result.rejected[1].reason, PickRejection::collision);
  EXPECT_NE(result.rejected[1].detail.find("object 1"), std::string::npos)
      << result.rejected[1].detail;
}

TEST_F(PickTest, ASurveyJudgesEachGraspAsItIsJudgedAlone) {
  scene.objects.push_back(box_of_points({0.2, 0.2, 0.3}, {0.45, -0.3, 0.15}));
  const std::vector<Grasp> grasps{from_above(3.0, 0.0, 0.1), from_above(0.45, 0.1, 0.12),
                                  from_above(0.45, -0.3, 0.2), from_above(0.44, 0.1, 0.12)};
  PickOptions one;
  one.max_grasps = 1;  // does not apply
  const PickSurvey survey =
      survey_picks(robot, robot.arms[0], gripper, robot.home, scene, grasps, one);
  std::size_t reached = 0, rejected = 0;
  for (std::size_t i = 0; i < grasps.size(); ++i) {
    const PickResult alone = plan({grasps[i]}, robot.home);
    if (alone.motion) {
      ASSERT_LT(reached, survey.reached.size());
      EXPECT_EQ(survey.reached[reached++], i);
    } else {
      ASSERT_LT(rejected, survey.rejected.size());
      EXPECT_EQ(survey.rejected[rejected].grasp, i);
      EXPECT_EQ(survey.rejected[rejected++].reason, alone.rejected[0].reason);
    }
  }
  EXPECT_EQ(reached, survey.reached.size());
  EXPECT_EQ(rejected, survey.rejected.size());
  ASSERT_TRUE(survey.motion);
  const PickResult first = plan(grasps, robot.home);
  ASSERT_TRUE(first.motion);
  EXPECT_EQ(survey.motion->grasp, first.motion->grasp);
  EXPECT_EQ(survey.motion->approach.duration(), first.motion->approach.duration());
}

/// A camera at the robot saw one side of the box, and neither what is behind it nor above 0.14 m.
TEST_F(PickTest, TakesAnObjectAfterOneLook) {
  OccupancyGrid space;
  space.frame = {{0.25F, -0.2F, -0.02F}, 0.01F, {50, 60, 36}};
  for (int z = 0; z < 36; ++z) {
    for (int y = 0; y < 60; ++y) {
      for (int x = 0; x < 50; ++x) {
        const bool shadow = x >= 20 && y >= 26 && y < 34 && z < 12;
        space.states.push_back(shadow || z >= 16 ? VoxelState::never_seen : VoxelState::free);
      }
    }
  }
  scene.space = space;
  const PickResult result = plan({from_above(0.45, 0.1, 0.12)}, robot.home);
  EXPECT_TRUE(result.motion) << (result.rejected.empty() ? result.start_contact
                                                         : result.rejected[0].detail);
}

TEST_F(PickTest, StatesAStartInCollision) {
  Eigen::VectorXd low = Eigen::VectorXd::Zero(6);
  low[1] = 2.2;
  const PickResult result = plan({from_above(0.45, 0.1, 0.12)}, low);
  EXPECT_FALSE(result.motion);
  EXPECT_NE(result.start_contact.find("the table"), std::string::npos);
}

TEST_F(PickTest, NeedsLimits) {
  robot.model.joints[2].limits.acceleration = 0.0;
  EXPECT_THROW(plan({from_above(0.45, 0.1, 0.12)}, robot.home), InputError);
}

TEST_F(PickTest, BecomesOneTrajectory) {
  const PickResult result = plan({from_above(0.45, 0.1, 0.12)}, robot.home);
  ASSERT_TRUE(result.motion);
  const JointTrajectory trajectory =
      pick_trajectory(*result.motion, robot.model, robot.arms[0].arm, gripper, 0.04);
  EXPECT_EQ(trajectory.joint_names.size(), 6U);
  EXPECT_EQ(trajectory.points.front().positions, robot.home);
  EXPECT_EQ(trajectory.points.front().time, 0.0);
  EXPECT_EQ(trajectory.points.back().velocities.norm(), 0.0);
  ASSERT_EQ(trajectory.parts.size(), 4U);
  EXPECT_EQ(trajectory.parts.back().end + 1, trajectory.points.size());
  for (std::size_t i = 1; i < trajectory.points.size(); ++i) {
    EXPECT_GT(trajectory.points[i].time, trajectory.points[i - 1].time);
    const Eigen::VectorXd step =
        trajectory.points[i].positions - trajectory.points[i - 1].positions;
    EXPECT_LT(step.cwiseAbs().maxCoeff(), 0.05);
  }
}

}  // namespace
}  // namespace symscene
