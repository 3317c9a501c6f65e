#pragma once

#include <map>
#include <string>

#include "symscene/core/scene.hpp"
#include "symscene/evaluation/evaluation.hpp"

namespace symscene::bench {

/// How a result compares with the truth of its scene, or the sum over scenes.
struct SceneScore {
  SettingCounts counts;
  std::map<std::string, OutcomeCounts> kinds;  ///< of which the fates are not known
  double seconds = 0.0;

  SceneScore& operator+=(const SceneScore& other);
};

/// `seconds` of the score stays zero.
SceneScore evaluate(const Scene& scene, const SceneTruth& truth, const SegmentationResult& result);

}  // namespace symscene::bench
