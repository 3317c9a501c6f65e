#pragma once

#include <optional>
#include <span>
#include <string>

#include "symscene/core/depth_frame.hpp"

namespace symscene::app {

/// How depth images become depths, and which depths are used.
struct DepthUse {
  double scale = 1000.0;   ///< value of the images that is 1 m [1/m]
  double min_depth = 0.2;  ///< [m]
  double max_depth = 6.0;  ///< [m]
};

/// A sentence if more than a fifth of the depths is not used, as with a wrong scale: the limits and
/// the median depth. If the median is outside the limits, also the usual scale with which it is
/// nearest to the depth of a table.
std::optional<std::string> depth_range_warning(std::span<const DepthFrame> frames,
                                               const DepthUse& use);

/// A sentence if the table that was found in a frame is larger than tables are, as with a scale too
/// small, although the depths are used: its area, and the usual scale with which the median depth
/// is most like that of a table. `area` is in m².
std::optional<std::string> large_table_warning(const DepthFrame& frame, double area,
                                               const DepthUse& use);

}  // namespace symscene::app
