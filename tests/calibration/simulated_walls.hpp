#pragma once

#include <optional>

#include "core/random.hpp"
#include "symscene/core/camera.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/simulation/camera_errors.hpp"

namespace symscene::calibration_test {

inline CameraIntrinsics small_camera() { return {160, 120, 131.0, 131.0, 79.5, 59.5}; }

/// A wall at a distance along the optical axis, turned about both axes of the image. [m, rad]
inline Plane wall_at(double distance, double about_x, double about_y) {
  const Eigen::Vector3d normal = Eigen::AngleAxisd(about_x, Eigen::Vector3d::UnitX()) *
                                 Eigen::AngleAxisd(about_y, Eigen::Vector3d::UnitY()) *
                                 Eigen::Vector3d(0.0, 0.0, -1.0);
  return {normal, -normal.z() * distance};
}

/// What a camera with a depth bias and noise of that share of z² measures of a wall.
inline std::vector<float> measured_wall(const Plane& wall, const CameraIntrinsics& camera,
                                        const DepthBias& bias, double noise, std::uint64_t seed) {
  Random random(seed);
  std::vector<float> depth(camera.pixels());
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const double z = -wall.offset / wall.normal.dot(camera.ray(u, v));
      const double seen = z * bias.factor(u, v, z) + noise * z * z * random.normal();
      depth[std::size_t{v} * camera.width + u] = static_cast<float>(seen);
    }
  }
  return depth;
}

/// Walls from 0.5 to 2.2 m, turned to different sides.
inline Plane wall_of(int i, int count) {
  const double distance = 0.5 * std::pow(2.2 / 0.5, i / (count - 1.0));
  return wall_at(distance, 0.3 * ((i % 3) - 1), 0.25 * ((i + 1) % 3 - 1));
}

}  // namespace symscene::calibration_test
