#include "picking/look_motion.hpp"

#include <gtest/gtest.h>

#include "symscene/grasping/gripper.hpp"
#include "symscene/io/robot.hpp"

#ifdef SYMSCENE_HAS_ROBOTS

namespace symscene {
namespace {

/// Whether the arm with the camera meets the bin on its way, checked every 20 ms.
bool meets(const LookMotion& motion, const Robot& robot, const Gripper& gripper,
           const PickBin& bin) {
  GraspScene scene;
  bin.add_walls_to(scene.obstacles);
  const MotionObstacles obstacles(scene);
  const RobotArm& arm = robot.arms[*robot.camera->arm];
  const ArmCollision collision(robot, arm, &gripper, gripper.max_opening, obstacles, robot.home);
  for (const TimedPath* path : {&motion.there, &motion.sweep, &motion.back}) {
    for (const JointState& state : sampled(*path, 0.02)) {
      if (collision.contact(state.position)) return true;
    }
  }
  return false;
}

class LookAtATable : public ::testing::Test {
 protected:
  Robot robot_ = read_robot("panda");
  Gripper gripper_ = named_gripper("panda");
  CameraLookOptions look_;
  PickOptions planning_;

  PlannedLook plan(const PickBin& bin) const {
    return plan_look(CameraArm(robot_, gripper_, bin, look_, planning_), look_);
  }
};

TEST_F(LookAtATable, AvoidsABinThatStandsInItsWay) {
  const PickBin far{{5.0, 5.0}, 0.26, 0.12};
  const PlannedLook free = plan(far);
  ASSERT_TRUE(free.motion) << free.obstacle;
  // A tall bin below the camera's arc.
  const PickBin in_the_way{{-0.1, 0.45}, 0.26, 0.6};
  ASSERT_TRUE(meets(*free.motion, robot_, gripper_, in_the_way));
  const PlannedLook around = plan(in_the_way);
  ASSERT_TRUE(around.motion) << around.obstacle;
  EXPECT_FALSE(meets(*around.motion, robot_, gripper_, in_the_way));
}

TEST_F(LookAtATable, SaysThatTheArmsHomeIsInTheSpaceForObjects) {
  look_.keep_out_radius = 0.35;
  look_.keep_out_height = 0.9;
  const PlannedLook look = plan({{5.0, 5.0}, 0.26, 0.12});
  EXPECT_FALSE(look.motion);
  EXPECT_NE(look.obstacle.find("keep_out_radius"), std::string::npos) << look.obstacle;
}

TEST_F(LookAtATable, ABinIsPlacedWhereTheArmReachesItAndDoesNotStandAtHome) {
  const TableOptions table{0.8, 0.8, 0.75, 0.0};
  const auto bin = reachable_bin(robot_, robot_.grasping_arm(), gripper_, table, {});
  ASSERT_TRUE(bin);
  const PlannedLook look = plan(*bin);
  ASSERT_TRUE(look.motion) << look.obstacle;
  EXPECT_FALSE(meets(*look.motion, robot_, gripper_, *bin));
  EXPECT_FALSE(bin->is_above({0.0, 0.0, 0.1}));
  EXPECT_TRUE(bin->is_above({bin->middle.x(), bin->middle.y(), 0.3}));
}

TEST_F(LookAtATable, ViewsOfTheArmShowTheTableFromManySidesAndAreFree) {
  const CameraArm arm(robot_, gripper_, {{5.0, 5.0}, 0.26, 0.12}, look_, planning_);
  const std::vector<ViewStation> stations = view_stations(arm, look_);
  EXPECT_GE(stations.size(), 8U);
  const Eigen::Vector3d target(0.0, 0.0, look_.target_height);
  for (const ViewStation& station : stations) {
    EXPECT_FALSE(arm.collision().contact(station.positions));
    const Eigen::Vector3d seen = station.T_table_camera.inverse() * target;
    EXPECT_LT(seen.head<2>().norm(), 1e-3) << "the camera looks at the table's middle";
    EXPECT_GE(seen.z(), look_.min_radius - 1e-3);
    EXPECT_LE(seen.z(), look_.max_radius + 1e-3);
  }
}

}  // namespace
}  // namespace symscene

#endif
