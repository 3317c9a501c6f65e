#include "exploration_tables.hpp"

#include <fmt/format.h>

#include "symscene/clutter/round_share.hpp"

namespace symscene {
namespace {

/// "+4.2" of 0.042.
std::string signed_percent(double share) { return fmt::format("{:+.1f}", 100.0 * share); }

std::string signed_interval(const Estimate& estimate) {
  return fmt::format("{} ({} to {})", signed_percent(estimate.value), signed_percent(estimate.low),
                     signed_percent(estimate.high));
}

/// The cells of a difference a − b: in points, and relative to b.
std::vector<std::string> difference_cells(const SceneStatistic& a, const SceneStatistic& b,
                                          std::size_t scenes) {
  return {signed_interval(estimate(difference(a, b), scenes)),
          signed_interval(estimate(relative_difference(a, b), scenes))};
}

bool has_grasps(const ComparedScenes& scenes) {
  for (const auto& [policy, explorations] : scenes.by_policy) {
    for (const ExplorationStep& step : explorations.front()->steps) {
      if (step.grasped) return true;
    }
  }
  return false;
}

}  // namespace

TextTable measure_table(const ComparedScenes& scenes, const ExplorationMeasure& measure) {
  TextTable table{{fmt::format("{}, %", measure.name)}};
  for (std::size_t k = 1; k <= scenes.views(); ++k) table.front().push_back(fmt::format("{}", k));
  table.front().push_back("mean");
  const std::vector<std::size_t> all = all_scenes(scenes.scenes());
  for (const auto& [policy, explorations] : scenes.by_policy) {
    table.push_back({to_string(policy)});
    for (std::size_t k = 0; k < scenes.views(); ++k)
      table.back().push_back(percent(at_view(explorations, measure, k)(all)));
    table.back().push_back(percent(area(explorations, measure)(all)));
  }
  return table;
}

TextTable grasp_table(const ComparedScenes& scenes) {
  TextTable table{{"grasp of the least visible object", "success"}};
  if (!has_grasps(scenes)) return table;
  for (const auto& [policy, explorations] : scenes.by_policy) {
    std::vector<ShareCounts> counts;
    for (std::size_t k = 0; k < explorations.size(); ++k) {
      const std::size_t own[] = {k};
      const bool success = grasp_success(explorations)(own) > 0.0;
      counts.push_back({success ? std::size_t{1} : 0, 1});
    }
    table.push_back({to_string(policy), share_with_interval(counts).text()});
  }
  return table;
}

TextTable difference_table(const ComparedScenes& scenes, ExplorationPolicy reference) {
  TextTable table{{fmt::format("{} minus", to_string(reference)), "of", "points", "relative, %"}};
  const auto first = scenes.by_policy.find(reference);
  if (first == scenes.by_policy.end()) return table;
  const auto add = [&](ExplorationPolicy other, const std::string& of, const SceneStatistic& a,
                       const SceneStatistic& b) {
    table.push_back({to_string(other), of});
    for (std::string& cell : difference_cells(a, b, scenes.scenes()))
      table.back().push_back(std::move(cell));
  };
  for (const auto& [policy, explorations] : scenes.by_policy) {
    if (policy == reference) continue;
    for (const ExplorationMeasure& measure : exploration_measures())
      add(policy, measure.name, area(first->second, measure), area(explorations, measure));
    if (has_grasps(scenes))
      add(policy, "success of the grasp", grasp_success(first->second),
          grasp_success(explorations));
  }
  return table;
}

TextTable half_arc_table(const ComparedScenes& scenes, ExplorationPolicy reference) {
  const std::size_t views = scenes.views(), half = views / 2;
  TextTable table{
      {fmt::format("{} after {} views minus fixed-arc after {}", to_string(reference), half, views),
       "points", "relative, %"}};
  const auto first = scenes.by_policy.find(reference);
  const auto arc = scenes.by_policy.find(ExplorationPolicy::fixed_arc);
  if (half == 0 || first == scenes.by_policy.end() || arc == scenes.by_policy.end()) return table;
  for (const ExplorationMeasure& measure : exploration_measures()) {
    table.push_back({measure.name});
    for (std::string& cell :
         difference_cells(at_view(first->second, measure, half - 1),
                          at_view(arc->second, measure, views - 1), scenes.scenes()))
      table.back().push_back(std::move(cell));
  }
  return table;
}

TextTable decision_table(const ComparedScenes& scenes) {
  TextTable table{{"time of a decision, ms", "median", "95 % below"}};
  for (const auto& [policy, explorations] : scenes.by_policy) {
    std::vector<double> times;
    for (const Exploration* e : explorations) {
      for (std::size_t k = 1; k < e->steps.size(); ++k)
        times.push_back(1e3 * e->steps[k].decision_seconds);
    }
    if (!times.empty())
      table.push_back({to_string(policy), fmt::format("{:.1f}", quantile_of(times, 0.5)),
                       fmt::format("{:.1f}", quantile_of(times, 0.95))});
  }
  return table;
}

}  // namespace symscene
