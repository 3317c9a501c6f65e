#pragma once

#include <Eigen/Geometry>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// A box of any orientation.
struct OrientedBox {
  Eigen::Isometry3d T_world_box = Eigen::Isometry3d::Identity();
  Eigen::Vector3d min = Eigen::Vector3d::Zero();  ///< in the box frame [m]
  Eigen::Vector3d max = Eigen::Vector3d::Zero();  ///< in the box frame [m]
};

/// The axis-aligned box in the world frame around it.
Box world_bounds(const OrientedBox& box);

}  // namespace symscene
