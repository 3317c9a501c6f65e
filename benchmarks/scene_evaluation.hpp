#pragma once

#include <map>
#include <string>

#include "symscene/core/scene.hpp"
#include "symscene/evaluation/evaluation.hpp"
#include "symscene/ground_truth/scene_truth.hpp"

namespace symscene::bench {

/// Counts of a result against the ground truth of its scene, or their sum over scenes.
struct SceneScore {
  SettingCounts counts;
  std::map<std::string, OutcomeCounts> kinds;  ///< without reasons for missed objects
  double seconds = 0.0;

  SceneScore& operator+=(const SceneScore& other);
};

/// Compares a result with the ground truth. `seconds` of the score stays zero.
SceneScore evaluate(const Scene& scene, const SceneTruth& truth, const SegmentationResult& result);

}  // namespace symscene::bench
