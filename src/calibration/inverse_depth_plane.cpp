#include "inverse_depth_plane.hpp"

#include <cmath>

#include <Eigen/LU>

namespace symscene {

std::optional<InverseDepthPlane> seen_plane(const Plane& plane_camera) {
  // n · (z ray) + d = 0, so 1/z = −n · ray / d.
  if (std::abs(plane_camera.offset) < 1e-9) return std::nullopt;
  return InverseDepthPlane{-plane_camera.normal / plane_camera.offset};
}

std::optional<InverseDepthPlane> search_plane(std::span<const DepthSample> samples,
                                              const CameraIntrinsics& camera, double tolerance,
                                              int draws, Random random) {
  if (samples.size() < 3) return std::nullopt;
  std::optional<InverseDepthPlane> best;
  std::size_t most = 2;
  const auto count = static_cast<std::uint32_t>(samples.size());
  for (int draw = 0; draw < draws; ++draw) {
    Eigen::Matrix3d rays;
    Eigen::Vector3d inverse;
    for (int k = 0; k < 3; ++k) {
      const DepthSample& sample = samples[random.below(count)];
      rays.row(k) = camera.ray(sample.u, sample.v);
      inverse[k] = 1.0 / sample.depth;
    }
    const InverseDepthPlane plane{rays.partialPivLu().solve(inverse)};
    if (!plane.coefficients.allFinite()) continue;
    std::size_t near = 0;
    for (const DepthSample& sample : samples) {
      const double error = plane.error(camera.ray(sample.u, sample.v), sample.depth);
      near += std::abs(error) < tolerance ? 1 : 0;
    }
    if (near > most) most = near, best = plane;
  }
  return best;
}

}  // namespace symscene
