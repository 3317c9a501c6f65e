#pragma once

#include <vector>

#include "symscene/ground_truth/scene_truth.hpp"

namespace symscene {

/// The number of entries of each object in `truth_met`: its strict symmetries that are not implied.
std::vector<std::size_t> axis_targets(const SceneTruth& truth);
std::vector<std::size_t> plane_targets(const SceneTruth& truth);

}  // namespace symscene
