#pragma once

#include <initializer_list>

#include <Eigen/Geometry>

namespace symscene {

/// T_world_tool of a gripper at `origin` whose fingers close along `closing`, its y axis, and that
/// approaches along `approach`, its z axis. Both are unit vectors at a right angle.
Eigen::Isometry3d tool_pose(const Eigen::Vector3d& origin, const Eigen::Vector3d& closing,
                            const Eigen::Vector3d& approach);

/// A unit vector across `direction`, a unit vector: the part across it of the first preferred one
/// that is not nearly along it, or else any.
Eigen::Vector3d direction_across(const Eigen::Vector3d& direction,
                                 std::initializer_list<Eigen::Vector3d> preferred);

}  // namespace symscene
