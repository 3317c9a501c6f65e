#pragma once

#include <optional>
#include <string>

#include "free_motion.hpp"
#include "pick_bin.hpp"
#include "symscene/motion/pick.hpp"
#include "symscene/picking/camera_look_options.hpp"
#include "symscene/robots/inverse_kinematics.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene {

/// The azimuth of the robot's base about the table's middle. [rad]
double azimuth_of_base(const Robot& robot);

/// The arm that carries the robot's camera, and what it must not meet while it looks: the robot
/// itself, the table, the bin, and the cylinder in which objects may stand. Frame of the table.
class CameraArm {
 public:
  /// References are kept. Throws InputError if the robot has no camera on an arm, or the camera
  /// does not move with the arm's tip.
  CameraArm(const Robot& robot, const Gripper& gripper, const PickBin& bin,
            const CameraLookOptions& options, const PickOptions& planning);
  CameraArm(const CameraArm&) = delete;

  const Arm& arm() const { return arm_.arm; }
  const Eigen::VectorXd& home() const { return home_; }
  const MotionLimits& limits() const { return limits_; }
  const ArmCollision& collision() const { return collision_; }
  MotionPlanner planner() const { return planner(limits_); }
  /// The same with other limits, which are kept by reference.
  MotionPlanner planner(const MotionLimits& limits) const {
    return {collision_, space_, limits, planning_.rrt};
  }
  double azimuth() const { return azimuth_; }  ///< of the base
  /// Why the arm cannot look from where it is at home; empty if it can.
  std::string blocked_home() const;
  /// Free joint positions that bring the camera to a pose, searched from `start` on.
  std::optional<Eigen::VectorXd> reach(const Eigen::Isometry3d& T_table_camera,
                                       const Eigen::VectorXd& start) const;
  /// T_table_camera.
  Eigen::Isometry3d camera_pose(const Eigen::VectorXd& positions) const;

 private:
  GraspScene scene(const PickBin& bin) const;

  const CameraLookOptions& options_;
  const PickOptions& planning_;
  const RobotArm& arm_;
  ArmChain chain_;
  JointSpace space_;
  MotionLimits limits_;
  MotionObstacles obstacles_;
  ArmCollision collision_;
  Eigen::VectorXd home_;
  Eigen::Isometry3d T_table_base_;
  Eigen::Isometry3d T_camera_tip_;
  double azimuth_;
};

}  // namespace symscene
