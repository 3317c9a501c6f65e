#pragma once

#include <string>

#include "symscene/core/scene.hpp"

namespace symscene::app {

/// One line an object: id, points, score, symmetries.
std::string format_objects(const SegmentationResult& result);

/// Entry by entry the median of the runs' stage times, which name the same stages.
std::vector<StageTime> median_times(const std::vector<std::vector<StageTime>>& runs);

}  // namespace symscene::app
