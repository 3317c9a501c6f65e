#include "exploration_measures.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/bootstrap.hpp"

namespace symscene {
namespace {

using Steps = std::span<const ExplorationStep* const>;

template <double ExplorationStep::*share>
double mean_share(Steps steps) {
  double sum = 0.0;
  for (const ExplorationStep* step : steps) sum += step->*share;
  return sum / static_cast<double>(std::max<std::size_t>(1, steps.size()));
}

template <DetectionCounts ExplorationStep::*counts>
DetectionCounts sum_of(Steps steps) {
  DetectionCounts sum;
  for (const ExplorationStep* step : steps) sum += step->*counts;
  return sum;
}

constexpr std::array measures{
    ExplorationMeasure{"surface observed", &mean_share<&ExplorationStep::observed>},
    ExplorationMeasure{"surface completed", &mean_share<&ExplorationStep::completed>},
    ExplorationMeasure{
        "F of masks, IoU > 0.75",
        [](Steps steps) { return sum_of<&ExplorationStep::masks>(steps).f_measure(); }},
    ExplorationMeasure{"recall of axes",
                       [](Steps steps) { return sum_of<&ExplorationStep::axes>(steps).recall(); }},
    ExplorationMeasure{"recall of planes", [](Steps steps) {
                         return sum_of<&ExplorationStep::planes>(steps).recall();
                       }}};

double value_at(const PolicyExplorations& explorations, const ExplorationMeasure& measure,
                std::size_t view, std::span<const std::size_t> scenes) {
  std::vector<const ExplorationStep*> steps;
  for (const std::size_t scene : scenes) steps.push_back(&explorations[scene]->steps[view]);
  return measure.value(steps);
}

bool is_grasped(const Exploration& exploration) {
  return std::any_of(exploration.steps.begin(), exploration.steps.end(),
                     [](const ExplorationStep& step) { return step.grasped.value_or(false); });
}

}  // namespace

std::span<const ExplorationMeasure> exploration_measures() { return measures; }

SceneStatistic at_view(const PolicyExplorations& explorations, const ExplorationMeasure& measure,
                       std::size_t view) {
  return [&explorations, measure, view](std::span<const std::size_t> scenes) {
    return value_at(explorations, measure, view, scenes);
  };
}

SceneStatistic area(const PolicyExplorations& explorations, const ExplorationMeasure& measure) {
  return [&explorations, measure](std::span<const std::size_t> scenes) {
    const std::size_t views = explorations.front()->steps.size();
    double sum = 0.0;
    for (std::size_t k = 0; k < views; ++k) sum += value_at(explorations, measure, k, scenes);
    return sum / static_cast<double>(views);
  };
}

SceneStatistic grasp_success(const PolicyExplorations& explorations) {
  return [&explorations](std::span<const std::size_t> scenes) {
    const auto successes = std::count_if(scenes.begin(), scenes.end(), [&](std::size_t scene) {
      return is_grasped(*explorations[scene]);
    });
    return static_cast<double>(successes) /
           static_cast<double>(std::max<std::size_t>(1, scenes.size()));
  };
}

SceneStatistic difference(SceneStatistic a, SceneStatistic b) {
  return [a = std::move(a), b = std::move(b)](std::span<const std::size_t> scenes) {
    return a(scenes) - b(scenes);
  };
}

SceneStatistic relative_difference(SceneStatistic a, SceneStatistic b) {
  return [a = std::move(a), b = std::move(b)](std::span<const std::size_t> scenes) {
    const double of = b(scenes);
    return of > 0.0 ? a(scenes) / of - 1.0 : 0.0;
  };
}

std::vector<std::size_t> all_scenes(std::size_t scenes) {
  std::vector<std::size_t> all(scenes);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

Estimate estimate(const SceneStatistic& statistic, std::size_t scenes) {
  const auto drawn = [&](std::span<const std::size_t> some) -> std::optional<double> {
    return statistic(some);
  };
  const Interval interval = bootstrap_interval(scenes, drawn).value_or(Interval{});
  return {statistic(all_scenes(scenes)), interval.low, interval.high};
}

}  // namespace symscene
