#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/camera.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// An image of a depth camera. Rows from the top; one entry a pixel of the camera that took it.
struct DepthFrame {
  double time = 0.0;         ///< when it was taken [s]
  std::vector<float> depth;  ///< along the optical axis, 0 where nothing was measured [m]
  Colors colors;             ///< of the same pixels, or 0×3
};

/// Where a camera was, and when.
struct StampedPose {
  double time = 0.0;  ///< [s]
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
};

/// The poses of a camera by rising time.
using Trajectory = std::vector<StampedPose>;

}  // namespace symscene
