#include "scene_evaluation.hpp"

namespace symscene::bench {

SceneScore& SceneScore::operator+=(const SceneScore& other) {
  counts += other.counts;
  seconds += other.seconds;
  for (const auto& [name, kind] : other.kinds) kinds[name] += kind;
  return *this;
}

SceneScore evaluate(const Scene& scene, const SceneTruth& truth, const SegmentationResult& result) {
  SceneScore score;
  score.counts = count_result(scene, truth, result);
  const auto masks = transfer_masks(scene.cloud, truth, result.cloud);
  for (const ObjectOutcome& outcome : object_outcomes(truth, masks, SceneProposals{}, result))
    score.kinds[outcome.kind].add(outcome);
  return score;
}

}  // namespace symscene::bench
