#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compared_scenes.hpp"

namespace symscene {

/// A measure of what is known after a view: a share.
struct ExplorationMeasure {
  const char* name;
  /// Of steps of several scenes together: means over scenes, or a ratio of sums of counts.
  double (*value)(std::span<const ExplorationStep* const> steps);
};

/// Observed and completed surface, F of masks, recall of axes and of planes.
std::span<const ExplorationMeasure> exploration_measures();

/// A number that is computed from scenes, given by their places among those that are compared.
using SceneStatistic = std::function<double(std::span<const std::size_t> scenes)>;

/// A measure after a view, counted from 0. The explorations must outlive the statistics.
SceneStatistic at_view(const PolicyExplorations& explorations, const ExplorationMeasure& measure,
                       std::size_t view);
/// Mean over the views of a measure: the area under its curve.
SceneStatistic area(const PolicyExplorations& explorations, const ExplorationMeasure& measure);
/// The share of scenes in which the grasp succeeded; one that was not tried did not.
SceneStatistic grasp_success(const PolicyExplorations& explorations);
/// a − b, and a / b − 1; 0 where b is 0.
SceneStatistic difference(SceneStatistic a, SceneStatistic b);
SceneStatistic relative_difference(SceneStatistic a, SceneStatistic b);

/// The places of all of so many scenes.
std::vector<std::size_t> all_scenes(std::size_t scenes);

/// A statistic of all scenes, and its 95 % interval by resampling scenes.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Of at least one scene.
Estimate estimate(const SceneStatistic& statistic, std::size_t scenes);

}  // namespace symscene
