#pragma once

#include <Eigen/Geometry>

namespace symscene {

/// T_world_camera of a camera at `eye` that looks along the unit vector `forward`, the top of its
/// image towards `up`; any way round where it looks along `up`. World frame. [m]
Eigen::Isometry3d looking_along(const Eigen::Vector3d& eye, const Eigen::Vector3d& forward,
                                const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ());

/// The same, towards `target`.
Eigen::Isometry3d looking_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target,
                             const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ());

}  // namespace symscene
