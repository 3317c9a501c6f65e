#include "tool_pose.hpp"

#include "symscene/core/geometry.hpp"
#include "symscene/core/gripper.hpp"

namespace symscene {

Eigen::Isometry3d tool_pose(const Eigen::Vector3d& origin, const Eigen::Vector3d& closing,
                            const Eigen::Vector3d& approach) {
  Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
  T_world_tool.linear() = tool_axes(closing, approach);
  T_world_tool.translation() = origin;
  return T_world_tool;
}

Eigen::Vector3d direction_across(const Eigen::Vector3d& direction,
                                 std::initializer_list<Eigen::Vector3d> preferred) {
  constexpr double nearly_along = 0.2;  // sine of the angle
  for (const Eigen::Vector3d& other : preferred) {
    const Eigen::Vector3d across = other - other.dot(direction) * direction;
    if (across.norm() > nearly_along) return across.normalized();
  }
  return orthonormal_complement(direction).col(0);
}

}  // namespace symscene
