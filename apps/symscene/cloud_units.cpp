#include "cloud_units.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "core/median.hpp"
#include "core/spacing.hpp"
#include "symscene/core/error.hpp"

namespace symscene::app {
namespace {

/// In metres, scenes are smaller; an object of this many millimetres is hardly larger than voxels.
constexpr double suspicious_extent = 5.0;
constexpr double building_extent = 20.0;  ///< [m]
/// A surface of so many voxels along each side has less than a hundred, too few for an object.
constexpr double fewest_voxels = 3.0;

/// The longest side of the box of the points without a twentieth at each end: outliers do not
/// count. [m]
double extent_of(const Points& points) {
  constexpr double left_out = 0.05;
  double longest = 0.0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::vector<float> along(points.col(axis).begin(), points.col(axis).end());
    const float low = quantile(along, left_out).value_or(0.0F);
    const float high = quantile(along, 1.0 - left_out).value_or(0.0F);
    longest = std::max(longest, double{high} - double{low});
  }
  return longest;
}

/// Of the distances of points from their nearest ones, one that nearly all exceed. [m]
double spacing_of(const Points& points) {
  constexpr double few = 0.02;
  return double{quantile(nearest_distances(points), few).value_or(0.0F)};
}

void require_larger_than_objects(double extent, const std::string& file,
                                 const PipelineOptions& options) {
  const double smallest = fewest_voxels * options.voxel_size;
  if (extent >= smallest) return;
  throw InputError(
      file, fmt::format("an extent of at least {:.3g} mm, with --units mm", 1e3 * smallest),
      fmt::format("{:.3g} mm (if the unit is the metre, leave out --units mm)", 1e3 * extent));
}

}  // namespace

std::optional<std::string> check_cloud_units(const Points& positions, bool is_scaled,
                                             const std::string& file,
                                             const PipelineOptions& options) {
  const Points points = positions(finite_points(positions), Eigen::all);
  if (points.rows() == 0) return {};
  const double extent = extent_of(points);
  if (is_scaled) {
    require_larger_than_objects(extent, file, options);
    return {};
  }
  if (extent < suspicious_extent) return {};
  const double spacing = spacing_of(points);
  if (spacing > options.stray_radius) {
    throw InputError(
        file, fmt::format("points less than {:g} m apart", options.stray_radius),
        fmt::format("{:.2g} m and more in a cloud of {:.3g} m (if the unit is the millimetre, give "
                    "--units mm)",
                    spacing, extent));
  }
  if (extent < building_extent) return {};
  return fmt::format(
      "{}: the cloud is {:.3g} m large: unless it is a building, its unit is the millimetre (give "
      "--units mm)",
      file, extent);
}

}  // namespace symscene::app
