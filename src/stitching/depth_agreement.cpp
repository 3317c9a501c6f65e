#include <cmath>

#include "symscene/stitching/pair_pose.hpp"

namespace symscene {
namespace {

/// A pixel that shows a surface, not an edge.
bool shows_surface(const SurfacePixel& pixel) { return pixel.nz < 0.0F; }

/// The pixel onto which a point falls; null outside the image and at edges.
const SurfacePixel* pixel_at(const SurfaceImage& image, const Eigen::Vector3d& point) {
  if (!(point.z() > 0.0)) return nullptr;
  const Eigen::Vector2d at = image.camera.project(point) + Eigen::Vector2d::Constant(0.5);
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < static_cast<double>(image.camera.width) &&
        at.y() < static_cast<double>(image.camera.height))) {
    return nullptr;
  }
  const SurfacePixel& pixel = image.pixels[static_cast<std::size_t>(at.y()) * image.camera.width +
                                           static_cast<std::size_t>(at.x())];
  return shows_surface(pixel) ? &pixel : nullptr;
}

}  // namespace

DepthAgreement depth_agreement(const SurfaceImage& moved, const SurfaceImage& fixed,
                               const Eigen::Isometry3d& T_fixed_moved, double tolerance,
                               const MeasurementOptions& sensor) {
  std::size_t points = 0, on_surface = 0, in_free_space = 0;
  for (Index v = 0; v < moved.camera.height; ++v) {
    for (Index u = 0; u < moved.camera.width; ++u) {
      const SurfacePixel& pixel = moved.pixels[std::size_t{v} * moved.camera.width + u];
      if (!shows_surface(pixel)) continue;
      ++points;
      const Eigen::Vector3d p =
          T_fixed_moved * (static_cast<double>(pixel.depth) * moved.camera.ray(u, v));
      const SurfacePixel* other = pixel_at(fixed, p);
      if (other == nullptr) continue;
      const auto seen = static_cast<double>(other->depth);
      const double bound = tolerance + 3.0 * sensor.deviation(seen);
      on_surface += std::abs(p.z() - seen) <= bound ? 1 : 0;
      in_free_space += p.z() < seen - bound ? 1 : 0;
    }
  }
  const auto share = [](std::size_t part, std::size_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
  };
  return {share(on_surface, points), share(on_surface, on_surface + in_free_space)};
}

}  // namespace symscene
