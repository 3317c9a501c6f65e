#pragma once

#include <string>

#include "symscene/core/scene.hpp"

namespace symscene::app {

/// A table with one line per object: id, points, score, symmetries.
std::string format_objects(const SegmentationResult& result);

/// The median time of each stage over runs with equal stages.
std::vector<StageTime> median_times(const std::vector<std::vector<StageTime>>& runs);

}  // namespace symscene::app
