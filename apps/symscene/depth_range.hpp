#pragma once

#include <optional>
#include <span>
#include <string>

#include "symscene/core/depth_frame.hpp"

namespace symscene::app {

/// A warning if many depths are outside the range for which the stages are made: the depth scale
/// may be wrong. None without depths.
std::optional<std::string> depth_range_warning(std::span<const DepthFrame> frames);

}  // namespace symscene::app
