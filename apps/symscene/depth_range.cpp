#include "depth_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "core/median.hpp"

namespace symscene::app {
namespace {

constexpr double max_outside = 0.2;  // share of the depths
constexpr double far_table = 4.0;    // [m]
constexpr double usual_depth = 1.0;  // of a table before a camera [m]
constexpr double large_table = 6.0;  // more than a camera sees of one [m²]

/// Metres, millimetres, the scale of the TUM benchmark, tenths of a millimetre. [1/m]
constexpr std::array<double, 4> usual_scales = {1.0, 1000.0, 5000.0, 10000.0};

bool is_used(double depth, const DepthUse& use) {
  return depth >= use.min_depth && depth <= use.max_depth;
}

double distance_from_usual(double depth) { return std::abs(std::log(depth / usual_depth)); }

/// The usual scale with which the median depth is most like that of a table; 0 if no scale makes it
/// more so than that of now.
double likely_scale(double median, double scale) {
  double best = scale;
  for (const double other : usual_scales) {
    if (distance_from_usual(median * scale / other) < distance_from_usual(median * scale / best))
      best = other;
  }
  return best == scale ? 0.0 : best;
}

/// Empty if the median depth is that of a table: the scale is then right, and what is far is not
/// used. One that is used but far may be that of a room.
std::string advice(double median, const DepthUse& use) {
  const double likely = likely_scale(median, use.scale);
  if (is_used(median, use)) {
    if (median < far_table || likely == 0.0) return "";
    return fmt::format(": unless it is a room, try --depth-scale {:g}, which makes it {:.3g} m",
                       likely, median * use.scale / likely);
  }
  if (likely == 0.0) return fmt::format(": is --depth-scale {:g} right?", use.scale);
  return fmt::format(": try --depth-scale {:g}, which makes it {:.3g} m, in place of {:g}", likely,
                     median * use.scale / likely, use.scale);
}

/// Of the depths that were measured, the share that is not used; 0 without any.
double share_outside(std::span<const DepthFrame> frames, const DepthUse& use) {
  std::size_t measured = 0, outside = 0;
  for (const DepthFrame& frame : frames) {
    for (const float depth : frame.depth) {
      if (!(depth > 0.0F)) continue;
      ++measured;
      outside += is_used(depth, use) ? 0 : 1;
    }
  }
  return static_cast<double>(outside) / std::max(static_cast<double>(measured), 1.0);
}

/// The median of the depths that were measured, of which there must be one. [m]
double median_of(std::span<const DepthFrame> frames) {
  std::vector<double> depths;
  for (const DepthFrame& frame : frames)
    std::copy_if(frame.depth.begin(), frame.depth.end(), std::back_inserter(depths),
                 [](float depth) { return depth > 0.0F; });
  return *median(std::move(depths));
}

}  // namespace

std::optional<std::string> depth_range_warning(std::span<const DepthFrame> frames,
                                               const DepthUse& use) {
  const double share = share_outside(frames, use);
  if (share <= max_outside) return {};
  const double median_depth = median_of(frames);
  return fmt::format(
      "{:.0f} % of the depths are outside {:g} to {:g} m and not used; the median depth is {:.3g} "
      "m{}",
      100.0 * share, use.min_depth, use.max_depth, median_depth, advice(median_depth, use));
}

std::optional<std::string> large_table_warning(const DepthFrame& frame, double area,
                                               const DepthUse& use) {
  if (area <= large_table) return {};
  const double median_depth = median_of({&frame, 1});
  const bool is_advised =
      share_outside({&frame, 1}, use) > max_outside && !advice(median_depth, use).empty();
  if (is_advised) return {};
  const double likely = likely_scale(median_depth, use.scale);
  if (likely == 0.0) return {};
  const double ratio = use.scale / likely;
  return fmt::format(
      "the table is {:.3g} m^2 large at a median depth of {:.3g} m: unless it is a floor, try "
      "--depth-scale {:g}, which makes it {:.2g} m^2 at {:.3g} m",
      area, median_depth, likely, area * ratio * ratio, median_depth * ratio);
}

}  // namespace symscene::app
