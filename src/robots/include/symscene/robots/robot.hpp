#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "symscene/core/gripper.hpp"
#include "symscene/robots/robot_model.hpp"

namespace symscene {

/// A joint of a finger: it stands at `share` of the opening between the fingers. [m per m, or rad]
struct FingerJoint {
  std::string name;
  double share = 0.5;
};

/// An arm with what is mounted on its tip link.
struct RobotArm {
  Arm arm;
  /// Name of a built-in gripper, or path of a gripper file; none if this arm does not grasp.
  std::optional<std::string> gripper;
  /// Pose of the gripper's wrist in the tip link.
  Eigen::Isometry3d T_tip_wrist = Eigen::Isometry3d::Identity();
  /// What drives the gripper on the real robot; for messages only.
  std::vector<FingerJoint> finger_joints = {};

  Eigen::Isometry3d T_tip_tool(const Gripper& gripper) const {
    return T_tip_wrist * gripper.T_wrist_tool;
  }
};

/// A depth camera on a link. Its frame has z forward and y down the image.
struct RobotCamera {
  std::size_t link = 0;
  Eigen::Isometry3d T_link_camera = Eigen::Isometry3d::Identity();
  /// Index of the arm that carries it; none if it does not move with an arm.
  std::optional<std::size_t> arm;
};

/// A robot as it stands in the world. Obstacles that are fixed to its base are capsules of its
/// root link.
struct Robot {
  RobotModel model;
  Eigen::Isometry3d T_world_base = Eigen::Isometry3d::Identity();
  std::vector<RobotArm> arms;
  std::optional<RobotCamera> camera;
  Eigen::VectorXd home;               ///< positions of all moving joints
  std::vector<std::string> warnings;  ///< sentences for the user, such as links without capsules

  /// The first arm with a gripper; the arm of that name. Throws InputError if there is none.
  const RobotArm& grasping_arm() const;
  const RobotArm& arm(std::string_view name) const;
};

}  // namespace symscene
