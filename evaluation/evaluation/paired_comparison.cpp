#include "paired_comparison.hpp"

#include <numeric>

#include "core/bootstrap.hpp"
#include "sweep_settings.hpp"

namespace symscene {
namespace {

std::optional<std::size_t> first_with_default(const Evaluation& evaluation) {
  for (std::size_t k = 0; k < evaluation.segmentation.size(); ++k) {
    if (evaluation.segmentation[k].at_default) return k;
  }
  return std::nullopt;
}

/// The counts of a method per scene: at its default, without one at a setting.
std::vector<DetectionCounts> counts_by_scene(const Evaluation& evaluation, std::size_t method,
                                             std::optional<std::size_t> setting) {
  std::vector<DetectionCounts> counts;
  for (const SceneEvaluation& scene : evaluation.scenes) {
    const Sweep& sweep = scene.segmentation[method];
    const SettingCounts& at = setting ? sweep.counts[*setting] : *sweep.at_default;
    counts.push_back(at.detections(Metric::masks_90));
  }
  return counts;
}

double f_of(const std::vector<DetectionCounts>& counts, std::span<const std::size_t> scenes) {
  DetectionCounts sum;
  for (const std::size_t scene : scenes) sum += counts[scene];
  return sum.f_measure();
}

MethodDifference compare(const Evaluation& evaluation, const std::vector<DetectionCounts>& first,
                         std::size_t method) {
  const Sweep& sweep = evaluation.segmentation[method];
  std::optional<std::size_t> setting;
  if (!sweep.at_default) setting = best_setting(sweep, Metric::masks_90);
  const std::vector<DetectionCounts> other = counts_by_scene(evaluation, method, setting);
  const auto difference = [&](std::span<const std::size_t> scenes) -> std::optional<double> {
    return f_of(first, scenes) - f_of(other, scenes);
  };
  std::vector<std::size_t> all(first.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const Interval interval = bootstrap_interval(all.size(), difference).value_or(Interval{});
  return {sweep.method,     setting ? "best: " + setting_text(sweep, *setting) : "default",
          f_of(other, all), difference(all).value_or(0.0),
          interval.low,     interval.high};
}

}  // namespace

std::vector<MethodDifference> paired_differences(const Evaluation& evaluation) {
  const auto reference = first_with_default(evaluation);
  std::vector<MethodDifference> differences;
  if (!reference || evaluation.scenes.size() < 2) return differences;
  const std::vector<DetectionCounts> first = counts_by_scene(evaluation, *reference, std::nullopt);
  for (std::size_t k = 0; k < evaluation.segmentation.size(); ++k) {
    const Sweep& sweep = evaluation.segmentation[k];
    if (k != *reference && (sweep.at_default || !sweep.counts.empty()))
      differences.push_back(compare(evaluation, first, k));
  }
  return differences;
}

std::string compared_method(const Evaluation& evaluation) {
  const auto reference = first_with_default(evaluation);
  return reference ? evaluation.segmentation[*reference].method : "";
}

}  // namespace symscene
