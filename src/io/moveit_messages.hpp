#pragma once

#include <optional>

#include "ros_json.hpp"
#include "symscene/io/moveit.hpp"

namespace symscene {

/// Messages of grasps and of what stands around them. All of it throws InputError if a number is
/// not finite.
class MoveItMessages {
 public:
  /// `scene` is kept.
  MoveItMessages(const MoveItScene& scene, RosVersion version);

  /// moveit_msgs/Grasp of the grasp with this index.
  Json grasp(std::size_t id) const;
  /// shape_msgs/Mesh of a surface, in the scene's frame.
  Json mesh(const TriangleMesh& surface) const;
  /// shape_msgs/SolidPrimitive of a box below all surfaces, and its pose; none without a table or a
  /// surface.
  struct Box {
    Json primitive, pose;
  };
  std::optional<Box> table_box() const;
  /// The coefficients of shape_msgs/Plane.
  Json table_plane() const;
  /// moveit_msgs/RobotTrajectory.
  Json robot_trajectory(const JointTrajectory& trajectory) const;

  const RosJson& ros() const { return ros_; }
  const MoveItScene& scene() const { return scene_; }

 private:
  Json posture(double opening) const;
  Json translation(const Eigen::Vector3d& direction_world, double distance) const;
  Eigen::Vector3d retreat_direction(const Eigen::Vector3d& approach) const;
  Eigen::Isometry3d T_world_table() const;
  std::optional<Eigen::AlignedBox3d> bounds_on_table() const;

  const MoveItScene& scene_;
  RosJson ros_;
};

/// "object_3".
std::string message_name(int object);

}  // namespace symscene
