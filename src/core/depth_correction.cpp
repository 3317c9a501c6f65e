#include "symscene/core/depth_correction.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr double least_factor = 0.5;
constexpr double greatest_factor = 2.0;

void require_grid(const DepthCorrection& grid) {
  const bool has_cells = grid.columns > 0 && grid.rows > 0 && grid.ranges > 0;
  const bool fits = grid.columns <= grid.width && grid.rows <= grid.height &&
                    grid.columns <= DepthCorrection::max_cells &&
                    grid.rows <= DepthCorrection::max_cells &&
                    grid.ranges <= DepthCorrection::max_cells;
  if (has_cells && fits && grid.cells() <= DepthCorrection::max_cells) return;
  throw InputError(
      "depth correction",
      fmt::format("1 to {} factors, at most one per pixel and depth", DepthCorrection::max_cells),
      fmt::format("{}×{} over {}×{} pixels, {} depths", grid.columns, grid.rows, grid.width,
                  grid.height, grid.ranges));
}

}  // namespace

AxisPlace place_on_axis(double value, Index count) {
  if (count == 1 || !(value > 0.0)) return {0, 0.0};
  const auto last = static_cast<double>(count - 1);
  if (value >= last) return {count - 2, 1.0};
  const auto node = static_cast<Index>(value);
  return {node, value - static_cast<double>(node)};
}

AxisPlace place_in_image(double pixel, Index size, Index nodes) {
  const double pixels = std::max<Index>(size, 2) - 1;
  return place_on_axis(pixel * (nodes - 1) / pixels, nodes);
}

double DepthCorrection::factor(double u, double v, double depth) const {
  const AxisPlace x = place_in_image(u, width, columns);
  const AxisPlace y = place_in_image(v, height, rows);
  const AxisPlace z = place_on_axis((depth - first_range) / range_step, ranges);
  const auto at = [&](Index dz, Index dy, Index dx) {
    const Index k = std::min(z.node + dz, ranges - 1);
    return double{
        factors[cell(k, std::min(y.node + dy, rows - 1), std::min(x.node + dx, columns - 1))]};
  };
  const auto on_row = [&](Index dz, Index dy) {
    return std::lerp(at(dz, dy, 0), at(dz, dy, 1), x.beyond);
  };
  const auto on_range = [&](Index dz) { return std::lerp(on_row(dz, 0), on_row(dz, 1), y.beyond); };
  return std::lerp(on_range(0), on_range(1), z.beyond);
}

void DepthCorrection::validate() const {
  require_grid(*this);
  if (!(range_step > 0.0) || !(first_range > 0.0) || !std::isfinite(range(ranges - 1)))
    throw InputError("depth correction", "depths above 0 in ascending order",
                     fmt::format("{} m in steps of {} m", first_range, range_step));
  if (factors.size() != cells() || measured.size() != cells())
    throw InputError("depth correction", fmt::format("{} factors, one per node", cells()),
                     fmt::format("{} and {} flags", factors.size(), measured.size()));
  for (const float factor : factors) {
    if (factor >= least_factor && factor <= greatest_factor) continue;
    throw InputError("depth correction",
                     fmt::format("factors from {} to {}", least_factor, greatest_factor),
                     fmt::format("{}", factor));
  }
}

}  // namespace symscene
