#include "paired_comparison.hpp"

#include <algorithm>
#include <random>

#include "sweep_settings.hpp"

namespace symscene {
namespace {

constexpr std::size_t draws = 2000;
constexpr std::uint64_t seed = 1;
constexpr double tail = 0.025;

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

double f_of(const std::vector<DetectionCounts>& counts, const std::vector<std::size_t>& scenes) {
  DetectionCounts sum;
  for (const std::size_t scene : scenes) sum += counts[scene];
  return sum.f_measure();
}

/// The differences of F over scenes that are drawn anew, ascending.
std::vector<double> drawn_differences(const std::vector<DetectionCounts>& first,
                                      const std::vector<DetectionCounts>& other) {
  std::mt19937_64 random(seed);
  std::vector<double> differences;
  std::vector<std::size_t> scenes(first.size());
  for (std::size_t k = 0; k < draws; ++k) {
    for (std::size_t& scene : scenes) scene = random() % first.size();
    differences.push_back(f_of(first, scenes) - f_of(other, scenes));
  }
  std::sort(differences.begin(), differences.end());
  return differences;
}

MethodDifference compare(const Evaluation& evaluation, const std::vector<DetectionCounts>& first,
                         std::size_t method) {
  const Sweep& sweep = evaluation.segmentation[method];
  std::optional<std::size_t> setting;
  if (!sweep.at_default) setting = best_setting(sweep, Metric::masks_90);
  const std::vector<DetectionCounts> other = counts_by_scene(evaluation, method, setting);
  const std::vector<double> drawn = drawn_differences(first, other);
  std::vector<std::size_t> all(first.size());
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
  const auto at = [&](double share) {
    return drawn[static_cast<std::size_t>(share * static_cast<double>(draws - 1))];
  };
  return {sweep.method,     setting ? "best: " + setting_text(sweep, *setting) : "default",
          f_of(other, all), f_of(first, all) - f_of(other, all),
          at(tail),         at(1.0 - tail)};
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
