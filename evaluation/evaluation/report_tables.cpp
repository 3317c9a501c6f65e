#include "report_tables.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "paired_comparison.hpp"
#include "sweep_settings.hpp"

namespace symscene {
namespace {

/// Short times keep two digits.
std::string seconds(double value) {
  return value >= 0.1 || value <= 0.0 ? fmt::format("{:.3f}", value) : fmt::format("{:.2g}", value);
}

std::string percent_or_dash(const std::optional<double>& share) {
  return share ? percent(*share) : "–";
}

/// F of a metric; none where there was nothing to find and nothing was found.
std::optional<double> f_if_any(const DetectionCounts& counts) {
  if (counts.found + counts.ground_truth == 0) return std::nullopt;
  return counts.f_measure();
}

HeadlineRow row_at(const Sweep& sweep, const SettingCounts& counts, std::string setting) {
  HeadlineRow row{sweep.method,
                  std::move(setting),
                  {},
                  counts.mean_overlap(),
                  counts.points.mean(counts.scenes),
                  {},
                  counts.detections(Metric::masks_90).found};
  if (counts.images > 0) row.pixels = counts.pixels.mean(counts.images);
  for (const Metric metric : sweep.metrics) {
    if (sweep.has(metric))
      row.f[static_cast<std::size_t>(metric)] = f_if_any(counts.detections(metric));
  }
  return row;
}

/// The setting with the greatest overlap F on label images.
std::optional<std::size_t> best_on_pixels(const Sweep& sweep) {
  const auto overlap_f = [&](std::size_t k) {
    return sweep.counts[k].pixels.mean(sweep.counts[k].images).overlap_f;
  };
  std::optional<std::size_t> best;
  for (std::size_t k = 0; k < sweep.counts.size(); ++k) {
    if (sweep.counts[k].images > 0 && (!best || overlap_f(k) > overlap_f(*best))) best = k;
  }
  return best;
}

std::vector<std::string> outcome_row(const std::string& name, const OutcomeCounts& counts) {
  std::vector<std::string> row{name, fmt::format("{}", counts.objects)};
  for (const Outcome outcome : all_outcomes)
    row.push_back(count_and_share(counts.count(outcome), counts.objects));
  return row;
}

/// The objects of a scene that were missed, by kind and outcome.
std::string missed_objects_of(const SceneEvaluation& scene) {
  std::string text;
  for (const ObjectOutcome& outcome : scene.objects) {
    if (outcome.outcome == Outcome::found) continue;
    if (!text.empty()) text += ", ";
    text += fmt::format("{}: {} ({})", outcome.kind, outcome_name(outcome.outcome), outcome.reason);
  }
  return text;
}

std::size_t count_found(const SceneEvaluation& scene) {
  return static_cast<std::size_t>(std::count_if(
      scene.objects.begin(), scene.objects.end(),
      [](const ObjectOutcome& outcome) { return outcome.outcome == Outcome::found; }));
}

double f_of(const SceneEvaluation& scene) {
  return DetectionCounts{count_found(scene), scene.returned, scene.objects.size()}.f_measure();
}

}  // namespace

std::string what_was_evaluated(const Evaluation& evaluation) {
  std::string text =
      fmt::format("{} scenes, {} objects", evaluation.scenes.size(), evaluation.outcomes.objects);
  const std::size_t small = evaluation.small_objects.objects;
  if (small > 0) text += fmt::format(", {} of them with few points", small);
  return text;
}

std::vector<HeadlineRow> headline(const std::vector<Sweep>& sweeps) {
  std::vector<HeadlineRow> rows;
  for (const Sweep& sweep : sweeps) {
    if (sweep.at_default) rows.push_back(row_at(sweep, *sweep.at_default, "default"));
    const auto best = best_setting(sweep, Metric::masks_90);
    if (!best) continue;
    rows.push_back(
        row_at(sweep, sweep.counts[*best], fmt::format("best of {}", sweep.settings.size())));
    for (const Metric metric : sweep.metrics) {
      if (!sweep.has(metric)) continue;
      const std::size_t its_best = best_setting(sweep, metric).value_or(0);
      rows.back().f[static_cast<std::size_t>(metric)] =
          f_if_any(sweep.counts[its_best].detections(metric));
    }
  }
  return rows;
}

TextTable headline_table(const std::vector<Sweep>& sweeps) {
  TextTable table{{"method", "setting", "masks .9", ".75", ".5", "axes", "planes", "axes 1cm",
                   "planes 1cm", "mean IoU", "overlap F", "boundary F", "F≥75", "masks"}};
  for (const HeadlineRow& row : headline(sweeps)) {
    std::vector<std::string> cells{row.method, row.setting};
    for (const auto& f : row.f) cells.push_back(percent_or_dash(f));
    std::optional<double> boundary_f;
    if (row.points.has_boundary()) boundary_f = row.points.boundary_f;
    cells.insert(cells.end(), {percent(row.mean_overlap), percent(row.points.overlap_f),
                               percent_or_dash(boundary_f), percent(row.points.found_75)});
    cells.push_back(fmt::format("{}", row.returned));
    table.push_back(std::move(cells));
  }
  return table;
}

TextTable pixel_table(const std::vector<Sweep>& sweeps) {
  TextTable table{
      {"pixels of label images", "setting", "overlap P", "R", "F", "boundary P", "R", "F", "%75"}};
  const auto add = [&](const Sweep& sweep, const std::string& setting,
                       const SettingCounts& counts) {
    if (counts.images == 0) return;
    const SegmentationMetrics mean = counts.pixels.mean(counts.images);
    table.push_back({sweep.method, setting});
    for (const double share :
         {mean.overlap_precision, mean.overlap_recall, mean.overlap_f, mean.boundary_precision,
          mean.boundary_recall, mean.boundary_f, mean.found_75})
      table.back().push_back(percent(share));
  };
  for (const Sweep& sweep : sweeps) {
    if (sweep.at_default) add(sweep, "default", *sweep.at_default);
    const auto best = best_on_pixels(sweep);
    if (best) add(sweep, "best: " + setting_text(sweep, *best), sweep.counts[*best]);
  }
  return table;
}

TextTable default_table(const std::vector<Sweep>& sweeps) {
  TextTable table{
      {"masks at 0.9", "precision", "recall", "F", "best F", "difference", "best setting"}};
  for (const Sweep& sweep : sweeps) {
    const auto best = best_setting(sweep, Metric::masks_90);
    if (!sweep.at_default || !best) continue;
    const DetectionCounts at_default = sweep.at_default->detections(Metric::masks_90);
    const double given = at_default.f_measure();
    const double greatest = sweep.counts[*best].detections(Metric::masks_90).f_measure();
    table.push_back({sweep.method, percent(at_default.precision()), percent(at_default.recall()),
                     percent(given), percent(greatest),
                     fmt::format("{:+.1f}", 100.0 * (given - greatest)),
                     setting_text(sweep, *best)});
  }
  return table;
}

TextTable missed_object_table(const Evaluation& evaluation) {
  TextTable table{{"kind", "objects"}};
  for (const Outcome outcome : all_outcomes) table.front().push_back(outcome_name(outcome));
  for (const auto& [name, counts] : evaluation.kinds) table.push_back(outcome_row(name, counts));
  if (evaluation.small_objects.objects > 0)
    table.push_back(outcome_row(fmt::format("fewer than {} points at 5 mm", small_object_points),
                                evaluation.small_objects));
  table.push_back(outcome_row("all", evaluation.outcomes));
  return table;
}

TextTable reason_table(const Evaluation& evaluation) {
  TextTable table{{"missed because", "reason", "objects"}};
  for (const Outcome outcome : all_outcomes) {
    for (const auto& [reason, count] :
         evaluation.outcomes.reasons[static_cast<std::size_t>(outcome)])
      table.push_back(
          {outcome_name(outcome), reason, count_and_share(count, evaluation.outcomes.objects)});
  }
  return table;
}

TextTable kind_table(const Evaluation& evaluation) {
  TextTable table{{"kind", "objects", "found .9", "found .75", "mean IoU", "symmetries", "met"}};
  for (const auto& [name, counts] : evaluation.kinds) {
    table.push_back({name, fmt::format("{}", counts.objects),
                     count_and_share(counts.count(Outcome::found), counts.objects),
                     count_and_share(counts.over_75, counts.objects),
                     percent(counts.mean_overlap()), fmt::format("{}", counts.symmetries),
                     count_and_share(counts.symmetries_met, counts.symmetries)});
  }
  return table;
}

TextTable runtime_table(const Evaluation& evaluation) {
  TextTable table{
      {"seconds per scene", "scenes", "rotational stage", "reflectional stage", "other", "total"}};
  for (const RuntimeClass& its : runtimes(evaluation)) {
    if (its.scenes == 0) continue;
    table.push_back({its.name, fmt::format("{}", its.scenes), seconds(its.rotational),
                     seconds(its.reflectional), seconds(its.other), seconds(its.total())});
  }
  return table;
}

TextTable method_time_table(const Evaluation& evaluation) {
  TextTable table{{"method", "seconds per scene"}};
  for (const Sweep& sweep : evaluation.segmentation) {
    if (sweep.seconds > 0.0)
      table.push_back(
          {sweep.method, seconds(sweep.seconds / static_cast<double>(evaluation.scenes.size()))});
  }
  return table;
}

TextTable paired_table(const Evaluation& evaluation) {
  TextTable table{{"method", "setting", "F", "difference", "95 % interval"}};
  for (const MethodDifference& each : paired_differences(evaluation)) {
    table.push_back({each.method, each.setting, percent(each.f),
                     fmt::format("{:+.1f}", 100.0 * each.difference),
                     fmt::format("{:+.1f} to {:+.1f}", 100.0 * each.low, 100.0 * each.high)});
  }
  return table;
}

TextTable without_empty_columns(TextTable table) {
  for (std::size_t column = table.front().size(); column-- > 0;) {
    const bool is_empty =
        table.size() > 1 && std::all_of(table.begin() + 1, table.end(),
                                        [&](const auto& row) { return row[column] == "–"; });
    if (!is_empty) continue;
    for (auto& row : table) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
  }
  return table;
}

TextTable worst_scene_table(const Evaluation& evaluation, std::size_t most) {
  std::vector<const SceneEvaluation*> scenes;
  for (const SceneEvaluation& scene : evaluation.scenes) scenes.push_back(&scene);
  std::stable_sort(
      scenes.begin(), scenes.end(),
      [](const SceneEvaluation* a, const SceneEvaluation* b) { return f_of(*a) < f_of(*b); });
  TextTable table{{"scene", "objects", "found", "returned", "F", "missed"}};
  for (const SceneEvaluation* scene : scenes) {
    if (table.size() > most || f_of(*scene) >= 1.0) break;
    table.push_back({scene->name, fmt::format("{}", scene->objects.size()),
                     fmt::format("{}", count_found(*scene)), fmt::format("{}", scene->returned),
                     percent(f_of(*scene)), missed_objects_of(*scene)});
  }
  return table;
}

std::string headline_text(const std::vector<Sweep>& sweeps) {
  return aligned(headline_table(sweeps), 2);
}

std::string default_text(const std::vector<Sweep>& sweeps) {
  return aligned(default_table(sweeps), 1);
}

std::string pixel_text(const std::vector<Sweep>& sweeps) {
  const TextTable table = pixel_table(sweeps);
  return table.size() == 1 ? "" : aligned(table, 2);
}

std::string missed_object_text(const Evaluation& evaluation) {
  const std::string missed = aligned(missed_object_table(evaluation), 1);
  const TextTable reasons = reason_table(evaluation);
  return reasons.size() == 1 ? missed : missed + "\n" + aligned(reasons, 2);
}

std::string runtime_text(const Evaluation& evaluation) {
  return aligned(runtime_table(evaluation), 1) + "\n" + aligned(method_time_table(evaluation), 1);
}

}  // namespace symscene
