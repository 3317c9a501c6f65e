#include <cmath>

#include "surface_lookup.hpp"
#include "symscene/stitching/pair_pose.hpp"

namespace symscene {

DepthAgreement depth_agreement(const SurfaceImage& moved, const SurfaceImage& fixed,
                               const Eigen::Isometry3d& T_fixed_moved, double tolerance,
                               const MeasurementOptions& sensor) {
  std::size_t points = 0, on_surface = 0, in_free_space = 0;
  for_each_surface_pixel(moved, [&](PixelPlace place, const SurfacePixel&) {
    ++points;
    const Eigen::Vector3d p = T_fixed_moved * point_of(moved, place);
    const std::optional<PixelPlace> other = find_pixel(fixed, p, 0.0);
    if (!other) return;
    const auto seen = static_cast<double>(pixel_of(fixed, *other).depth);
    const double bound = tolerance + 3.0 * sensor.deviation(seen);
    on_surface += std::abs(p.z() - seen) <= bound ? 1 : 0;
    in_free_space += p.z() < seen - bound ? 1 : 0;
  });
  const auto share = [](std::size_t part, std::size_t whole) {
    return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
  };
  return {share(on_surface, points), share(on_surface, on_surface + in_free_space)};
}

}  // namespace symscene
