#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/camera.hpp"

namespace symscene {

/// A depth image with colour from a known pose, and the object that each pixel shows. Every array
/// has one entry per pixel, row by row from the top.
struct SensorFrame {
  static constexpr Index nothing = ~Index{0};

  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  std::vector<float> depth;    ///< along the optical axis, 0 where nothing was measured [m]
  std::vector<Index> objects;  ///< number of the mesh that the pixel shows, or `nothing`
  std::vector<float> cosines;  ///< of the angle between the surface's normal and the ray
  Colors colors;
};

}  // namespace symscene
