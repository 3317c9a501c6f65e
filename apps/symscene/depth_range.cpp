#include "depth_range.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace symscene::app {
namespace {

constexpr double min_depth = 0.2;    // [m]
constexpr double max_depth = 6.0;    // [m]
constexpr double max_outside = 0.2;  // share of the depths

}  // namespace

std::optional<std::string> depth_range_warning(std::span<const DepthFrame> frames) {
  std::size_t measured = 0, outside = 0;
  for (const DepthFrame& frame : frames) {
    for (const double depth : frame.depth) {
      if (!(depth > 0.0)) continue;
      ++measured;
      outside += depth < min_depth || depth > max_depth ? 1 : 0;
    }
  }
  const double share = static_cast<double>(outside) / std::max(static_cast<double>(measured), 1.0);
  if (share <= max_outside) return {};
  return fmt::format("{:.0f} % of the depths are outside {} to {} m: is --depth-scale right?",
                     100.0 * share, min_depth, max_depth);
}

}  // namespace symscene::app
