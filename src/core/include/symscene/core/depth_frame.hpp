#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/camera.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// An image of a depth camera: one entry per pixel, rows from the top.
struct DepthFrame {
  double time = 0.0;         ///< when it was taken [s]
  std::vector<float> depth;  ///< along the optical axis, 0 where there is no measurement [m]
  Colors colors;             ///< per pixel, registered to the depth, or 0×3
};

/// A camera pose and its time.
struct StampedPose {
  double time = 0.0;  ///< [s]
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
};

/// The poses of a camera in ascending order of time.
using Trajectory = std::vector<StampedPose>;

}  // namespace symscene
