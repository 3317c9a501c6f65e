#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/grasp.hpp"
#include "symscene/core/gripper.hpp"
#include "symscene/core/joint_trajectory.hpp"
#include "symscene/core/triangle_mesh.hpp"
#include "symscene/io/ros_version.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene {

/// What MoveIt needs to pick objects. References are kept.
struct MoveItScene {
  std::string frame;  ///< name of the frame of all poses, such as the robot's root link
  Eigen::Isometry3d T_frame_world = Eigen::Isometry3d::Identity();
  std::span<const Grasp> grasps;
  const Gripper& gripper;
  /// Pose in the tool frame of the link whose pose a grasp is: the parent link of the end effector.
  Eigen::Isometry3d T_tool_link = Eigen::Isometry3d::Identity();
  std::span<const TriangleMesh> surfaces;       ///< closed, per object; world frame [m]
  std::optional<Plane> table;                   ///< world frame
  std::vector<FingerJoint> finger_joints = {};  ///< of the postures, which are else empty
  const JointTrajectory* trajectory = nullptr;  ///< of the arm; none if nothing is planned
};

/// {"grasps": [moveit_msgs/Grasp], "collision_objects": [moveit_msgs/CollisionObject],
/// "robot_trajectory": moveit_msgs/RobotTrajectory} by the names of their fields, with the grasps
/// in their order, and the trajectory if there is one. Vertices are rounded to 10 micrometres.
/// Objects are meshes "object_N"; those without a surface are left out. The table is a box below
/// the objects. Throws InputError if a number is not finite.
std::string format_moveit_json(const MoveItScene& scene, RosVersion version = RosVersion::ros2);

/// The same as YAML.
std::string format_moveit_yaml(const MoveItScene& scene, RosVersion version = RosVersion::ros2);

}  // namespace symscene
