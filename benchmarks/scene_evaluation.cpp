#include "scene_evaluation.hpp"

namespace symscene::bench {
namespace {

std::vector<PointIndices> masks_of(const SegmentationResult& result) {
  std::vector<PointIndices> masks;
  for (const SceneObject& object : result.objects) masks.push_back(object.points);
  return masks;
}

/// Counts the next `count` entries of a scene's list of met symmetries.
void count_met(const SymmetryMatch& match, std::size_t count, std::size_t& next, KindScore& kind) {
  kind.symmetries += count;
  for (std::size_t k = 0; k < count; ++k) kind.symmetries_met += match.truth_met[next++] ? 1 : 0;
}

}  // namespace

KindScore& KindScore::operator+=(const KindScore& other) {
  objects += other.objects;
  over_90 += other.over_90;
  over_75 += other.over_75;
  overlap_sum += other.overlap_sum;
  symmetries += other.symmetries;
  symmetries_met += other.symmetries_met;
  return *this;
}

SceneScore& SceneScore::operator+=(const SceneScore& other) {
  over_90 += other.over_90;
  over_75 += other.over_75;
  axes += other.axes;
  planes += other.planes;
  overlap_sum += other.overlap_sum;
  seconds += other.seconds;
  for (const auto& [name, kind] : other.kinds) kinds[name] += kind;
  return *this;
}

SceneScore evaluate(const Scene& scene, const SceneTruth& truth, const SegmentationResult& result) {
  const OverlapMatrix overlaps =
      overlap_matrix(transfer_masks(scene.cloud, truth, result.cloud), masks_of(result));
  const std::vector<double> best = best_overlaps(overlaps);
  const SymmetryTolerance tolerance;
  const SymmetryMatch axes = match_axes(truth, all_axes(result.objects), tolerance);
  const SymmetryMatch planes = match_planes(truth, all_planes(result.objects), tolerance);
  SceneScore score;
  score.over_90 = mask_score(overlaps, 0.9);
  score.over_75 = mask_score(overlaps, 0.75);
  score.axes = axes.score();
  score.planes = planes.score();
  const std::vector<std::size_t> to_meet_axes = axis_targets(truth);
  const std::vector<std::size_t> to_meet_planes = plane_targets(truth);
  std::size_t next_axis = 0;
  std::size_t next_plane = 0;
  for (std::size_t k = 0; k < truth.objects.size(); ++k) {
    KindScore kind;
    kind.objects = 1;
    kind.over_90 = best[k] > 0.9 ? 1 : 0;
    kind.over_75 = best[k] > 0.75 ? 1 : 0;
    kind.overlap_sum = best[k];
    count_met(axes, to_meet_axes[k], next_axis, kind);
    count_met(planes, to_meet_planes[k], next_plane, kind);
    score.kinds[truth.objects[k].name] += kind;
    score.overlap_sum += best[k];
  }
  return score;
}

}  // namespace symscene::bench
