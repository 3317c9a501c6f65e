#pragma once

#include <optional>
#include <span>

#include "core/random.hpp"
#include "depth_samples.hpp"

namespace symscene {

/// A plane as a camera sees it: 1/z = coefficients · (x, y, 1) along the ray (x, y, 1). [1/m]
struct InverseDepthPlane {
  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();

  /// Depth along a ray with z = 1; not positive where the plane is behind the camera. [m]
  double depth(const Eigen::Vector3d& ray) const { return 1.0 / coefficients.dot(ray); }
  /// Difference from the plane, over depth.
  double error(const Eigen::Vector3d& ray, double z) const {
    return z * coefficients.dot(ray) - 1.0;
  }
};

/// None if the plane goes through the camera.
std::optional<InverseDepthPlane> seen_plane(const Plane& plane_camera);

/// The plane of most samples within a tolerance, from `draws` random triples (Fischler and Bolles
/// 1981). None without three samples.
std::optional<InverseDepthPlane> search_plane(std::span<const DepthSample> samples,
                                              const CameraIntrinsics& camera, double tolerance,
                                              int draws, Random random);

}  // namespace symscene
