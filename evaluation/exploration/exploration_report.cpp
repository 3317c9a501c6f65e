#include "symscene/exploration/exploration_report.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "core/bootstrap.hpp"
#include "symscene/clutter/round_share.hpp"

namespace symscene {
namespace {

/// Explorations of a policy, one per scene in ascending order.
using ByPolicy = std::map<ExplorationPolicy, std::vector<const Exploration*>>;
using StepMeasure = std::function<double(const ExplorationStep&)>;
using StepCounts = std::function<DetectionCounts(const ExplorationStep&)>;
using Measure = std::function<double(const Exploration&)>;

/// Those of the scenes in which every policy has the most steps.
ByPolicy complete_scenes(std::span<const Exploration> explorations) {
  std::size_t most = 0;
  for (const Exploration& e : explorations) most = std::max(most, e.steps.size());
  std::set<int> incomplete;
  for (const Exploration& e : explorations) {
    if (e.steps.size() < most) incomplete.insert(e.scene);
  }
  ByPolicy by_policy;
  for (const Exploration& e : explorations) {
    if (incomplete.count(e.scene) == 0) by_policy[e.policy].push_back(&e);
  }
  return by_policy;
}

double mean_over(const std::vector<const Exploration*>& explorations, const Measure& measure) {
  double sum = 0.0;
  for (const Exploration* e : explorations) sum += measure(*e);
  return sum / static_cast<double>(std::max<std::size_t>(1, explorations.size()));
}

std::size_t views_of(const ByPolicy& by_policy) {
  return by_policy.empty() ? 0 : by_policy.begin()->second.front()->steps.size();
}

std::string table_of(const ByPolicy& by_policy, const char* title, const StepMeasure& measure) {
  std::string text = fmt::format("{}\n  {:<18}", title, "views");
  for (std::size_t k = 1; k <= views_of(by_policy); ++k) text += fmt::format(" {:>6}", k);
  text += fmt::format(" {:>6}\n", "mean");
  for (const auto& [policy, explorations] : by_policy) {
    text += fmt::format("  {:<18}", to_string(policy));
    double sum = 0.0;
    for (std::size_t k = 0; k < views_of(by_policy); ++k) {
      const double value =
          mean_over(explorations, [&](const Exploration& e) { return measure(e.steps[k]); });
      text += fmt::format(" {:6.3f}", value);
      sum += value;
    }
    text += fmt::format(" {:6.3f}\n", sum / static_cast<double>(views_of(by_policy)));
  }
  return text;
}

/// A share of the counts of all scenes together.
std::string count_table(const ByPolicy& by_policy, const char* title, const StepCounts& counts_of,
                        double (DetectionCounts::*share)() const) {
  std::string text = fmt::format("{}\n", title);
  for (const auto& [policy, explorations] : by_policy) {
    text += fmt::format("  {:<18}", to_string(policy));
    for (std::size_t k = 0; k < views_of(by_policy); ++k) {
      DetectionCounts counts;
      for (const Exploration* e : explorations) counts += counts_of(e->steps[k]);
      text += fmt::format(" {:6.3f}", (counts.*share)());
    }
    text += '\n';
  }
  return text;
}

/// 1 or 0; 0 where nothing was tried.
double grasp_success(const Exploration& exploration) {
  for (const ExplorationStep& step : exploration.steps) {
    if (step.grasped) return *step.grasped ? 1.0 : 0.0;
  }
  return 0.0;
}

std::vector<double> differences(const std::vector<const Exploration*>& a,
                                const std::vector<const Exploration*>& b, const Measure& measure) {
  std::vector<double> values;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    values.push_back(measure(*a[i]) - measure(*b[i]));
  return values;
}

std::string differences_text(const ByPolicy& by_policy, ExplorationPolicy reference,
                             const char* title, const Measure& measure) {
  const auto found = by_policy.find(reference);
  if (found == by_policy.end()) return {};
  std::string text = fmt::format("{}: {} minus\n", title, to_string(reference));
  for (const auto& [policy, explorations] : by_policy) {
    if (policy == reference) continue;
    const PairedDifference d = paired_difference(differences(found->second, explorations, measure));
    const double other = mean_over(explorations, measure);
    text += fmt::format("  {:<18} {:+.3f} (95 % interval {:+.3f} to {:+.3f})", to_string(policy),
                        d.mean, d.low, d.high);
    if (other > 0.0) text += fmt::format(", {:+.1f} %", 100.0 * d.mean / other);
    text += '\n';
  }
  return text;
}

std::string grasp_text(const ByPolicy& by_policy) {
  std::string text = "best grasp of the least visible object\n";
  for (const auto& [policy, explorations] : by_policy) {
    std::vector<ShareCounts> counts;
    for (const Exploration* e : explorations)
      counts.push_back({grasp_success(*e) > 0.0 ? std::size_t{1} : 0, 1});
    text += fmt::format("  {:<18} {}\n", to_string(policy), share_with_interval(counts).text());
  }
  return text;
}

std::string decision_text(const ByPolicy& by_policy) {
  std::string text = "time of a decision [ms]: median, 95 % below\n";
  for (const auto& [policy, explorations] : by_policy) {
    std::vector<double> times;
    for (const Exploration* e : explorations) {
      for (std::size_t k = 1; k < e->steps.size(); ++k)
        times.push_back(1e3 * e->steps[k].decision_seconds);
    }
    if (!times.empty())
      text += fmt::format("  {:<18} {:6.1f} {:6.1f}\n", to_string(policy), quantile_of(times, 0.5),
                          quantile_of(times, 0.95));
  }
  return text;
}

std::string counts_csv(const DetectionCounts& counts) {
  return fmt::format("{},{},{}", counts.correct, counts.found, counts.ground_truth);
}

}  // namespace

PairedDifference paired_difference(std::span<const double> differences) {
  PairedDifference result;
  result.scenes = differences.size();
  if (differences.empty()) return result;
  const auto mean = [&](std::span<const std::size_t> scenes) -> std::optional<double> {
    double sum = 0.0;
    for (const std::size_t scene : scenes) sum += differences[scene];
    return sum / static_cast<double>(scenes.size());
  };
  std::vector<std::size_t> all(differences.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  result.mean = mean(all).value_or(0.0);
  const Interval interval = bootstrap_interval(all.size(), mean).value_or(Interval{});
  result.low = interval.low;
  result.high = interval.high;
  return result;
}

std::string format_exploration_report(std::span<const Exploration> explorations,
                                      ExplorationPolicy reference) {
  const ByPolicy by_policy = complete_scenes(explorations);
  if (by_policy.empty()) return "no scene\n";
  std::string text = fmt::format("{} scenes\n", by_policy.begin()->second.size());
  text += table_of(by_policy, "surface observed", [](const auto& s) { return s.observed; });
  text += table_of(by_policy, "surface completed", [](const auto& s) { return s.completed; });
  text += count_table(
      by_policy, "F of masks at an overlap of 0.75", [](const auto& s) { return s.masks; },
      &DetectionCounts::f_measure);
  text += count_table(
      by_policy, "recall of axes within 10° and 1 cm", [](const auto& s) { return s.axes; },
      &DetectionCounts::recall);
  text += count_table(
      by_policy, "recall of planes within 10° and 1 cm", [](const auto& s) { return s.planes; },
      &DetectionCounts::recall);
  text += grasp_text(by_policy);
  text += differences_text(by_policy, reference, "area under the curve of observed surface",
                           [](const auto& e) { return e.mean_observed(); });
  text += differences_text(by_policy, reference, "area under the curve of completed surface",
                           [](const auto& e) { return e.mean_completed(); });
  text += differences_text(by_policy, reference, "success of the grasp", grasp_success);
  return text + decision_text(by_policy);
}

std::string format_explorations_csv(std::span<const Exploration> explorations) {
  std::string csv =
      "kind,scene,policy,views,candidate,observed,completed,masks_correct,masks_found,masks_true,"
      "axes_correct,axes_found,axes_true,planes_correct,planes_found,planes_true,grasped,"
      "decision_seconds\n";
  for (const Exploration& e : explorations) {
    for (std::size_t k = 0; k < e.steps.size(); ++k) {
      const ExplorationStep& s = e.steps[k];
      csv += fmt::format("{},{},{},{},{},{:.4f},{:.4f},{},{},{},{},{:.4f}\n", e.kind, e.scene,
                         to_string(e.policy), k + 1, s.view, s.observed, s.completed,
                         counts_csv(s.masks), counts_csv(s.axes), counts_csv(s.planes),
                         s.grasped ? (*s.grasped ? "1" : "0") : "", s.decision_seconds);
    }
  }
  return csv;
}

}  // namespace symscene
