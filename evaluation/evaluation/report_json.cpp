#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "evaluation/report_text.hpp"
#include "sweep_settings.hpp"
#include "symscene/core/error.hpp"
#include "symscene/evaluation/report.hpp"

namespace symscene {
namespace {

using Json = nlohmann::ordered_json;

/// 3 since every labelled object counts, and since there are metrics of pixels; 4 since the metrics
/// on points are called `points`. The headline is the same in both.
constexpr int report_version = 4;
constexpr int first_comparable_version = 3;

/// Without boundaries in the ground truth there are no metrics of boundaries.
Json to_json(const SegmentationMetrics& metrics) {
  Json json = {{"overlap_precision", metrics.overlap_precision},
               {"overlap_recall", metrics.overlap_recall},
               {"overlap_f", metrics.overlap_f}};
  if (metrics.has_boundary()) {
    json["boundary_precision"] = metrics.boundary_precision;
    json["boundary_recall"] = metrics.boundary_recall;
    json["boundary_f"] = metrics.boundary_f;
  }
  json["f_75"] = metrics.found_75;
  return json;
}

/// null where there was nothing to find and nothing was found.
Json f_of(const DetectionCounts& counts) {
  return counts.found + counts.ground_truth == 0 ? Json(nullptr) : Json(counts.f_measure());
}

bool has_masks(const Sweep& sweep) { return sweep.has(Metric::masks_90); }

Json to_json(const Sweep& sweep, const SettingCounts& counts) {
  Json json = Json::object();
  for (const Metric metric : sweep.metrics) {
    if (!sweep.has(metric)) continue;
    const DetectionCounts& detections = counts.detections(metric);
    json[metric_name(metric)] = {{"correct", detections.correct},
                                 {"found", detections.found},
                                 {"truth", detections.ground_truth},
                                 {"f", f_of(detections)}};
  }
  if (has_masks(sweep)) {
    json["mean_iou"] = counts.mean_overlap();
    json["points"] = to_json(counts.points.mean(counts.scenes));
  }
  if (counts.images > 0) json["pixels"] = to_json(counts.pixels.mean(counts.images));
  return json;
}

Json to_json(const Sweep& sweep) {
  Json json = {{"method", sweep.method}, {"parameters", sweep.parameters}};
  if (sweep.at_default) json["default"] = to_json(sweep, *sweep.at_default);
  Json best = Json::object();
  for (const Metric metric : sweep.metrics) {
    if (!sweep.has(metric)) continue;
    if (const auto k = best_setting(sweep, metric)) {
      best[metric_name(metric)] = {{"setting", sweep.settings[*k]},
                                   {"f", f_of(sweep.counts[*k].detections(metric))}};
    }
  }
  json["best"] = std::move(best);
  json["settings"] = Json::array();
  for (std::size_t k = 0; k < sweep.settings.size(); ++k) {
    Json setting = to_json(sweep, sweep.counts[k]);
    setting["setting"] = sweep.settings[k];
    json["settings"].push_back(std::move(setting));
  }
  json["seconds"] = sweep.seconds;
  return json;
}

Json to_json(const std::vector<Sweep>& sweeps) {
  Json json = Json::array();
  for (const Sweep& sweep : sweeps) json.push_back(to_json(sweep));
  return json;
}

Json headline_json(const std::vector<Sweep>& sweeps) {
  Json json = Json::array();
  for (const HeadlineRow& row : headline(sweeps)) {
    Json numbers = Json::object();
    for (const Metric metric : all_metrics) {
      const auto& f = row.f[static_cast<std::size_t>(metric)];
      if (f) numbers[metric_name(metric)] = *f;
    }
    numbers["mean_iou"] = row.mean_overlap;
    numbers["overlap_f"] = row.points.overlap_f;
    if (row.points.has_boundary()) numbers["boundary_f"] = row.points.boundary_f;
    numbers["f_75"] = row.points.found_75;
    if (row.pixels) {
      numbers["pixel_overlap_f"] = row.pixels->overlap_f;
      numbers["pixel_boundary_f"] = row.pixels->boundary_f;
      numbers["pixel_f_75"] = row.pixels->found_75;
    }
    json.push_back({{"method", row.method},
                    {"setting", row.setting.starts_with("best") ? "best" : row.setting},
                    {"numbers", std::move(numbers)}});
  }
  return json;
}

Json to_json(const OutcomeCounts& counts) {
  Json json = {{"objects", counts.objects}};
  for (const Outcome outcome : all_outcomes) {
    Json reasons = Json::object();
    for (const auto& [reason, count] : counts.reasons[static_cast<std::size_t>(outcome)])
      reasons[reason] = count;
    json[outcome_name(outcome)] = {{"objects", counts.count(outcome)},
                                   {"reasons", std::move(reasons)}};
  }
  json["symmetries"] = counts.symmetries;
  json["symmetries_met"] = counts.symmetries_met;
  return json;
}

Json missed_objects_json(const Evaluation& evaluation) {
  Json json = {{"all", to_json(evaluation.outcomes)},
               {"small", to_json(evaluation.small_objects)},
               {"kinds", Json::object()}};
  for (const auto& [kind, counts] : evaluation.kinds) json["kinds"][kind] = to_json(counts);
  return json;
}

Json to_json(const SceneEvaluation& scene) {
  Json times = Json::object();
  for (const StageTime& time : scene.timings)
    times[time.stage] = times.value(time.stage, 0.0) + time.seconds;
  Json json = {{"name", scene.name}, {"subset", scene.subset}, {"returned", scene.returned}};
  json["objects"] = Json::array();
  for (const ObjectOutcome& outcome : scene.objects) {
    json["objects"].push_back({{"kind", outcome.kind},
                               {"points", outcome.points},
                               {"small", outcome.is_small},
                               {"best_iou", outcome.best_overlap},
                               {"best_proposal_iou", outcome.best_proposal_overlap},
                               {"outcome", outcome_name(outcome.outcome)},
                               {"reason", outcome.reason}});
  }
  json["timings"] = std::move(times);
  return json;
}

Json runtimes_json(const Evaluation& evaluation) {
  Json json = Json::array();
  for (const RuntimeClass& its : runtimes(evaluation)) {
    json.push_back({{"name", its.name},
                    {"scenes", its.scenes},
                    {"rotational", its.rotational},
                    {"reflectional", its.reflectional},
                    {"other", its.other},
                    {"total", its.total()}});
  }
  return json;
}

/// The headline of a report by method and setting.
std::map<std::string, std::map<std::string, double>> headline_numbers(const std::string& text,
                                                                      const std::string& name) {
  std::map<std::string, std::map<std::string, double>> rows;
  try {
    const Json report = Json::parse(text);
    const int version = report.at("version").get<int>();
    if (version < first_comparable_version || version > report_version) {
      throw InputError(
          name,
          fmt::format("a report of version {} to {}", first_comparable_version, report_version),
          fmt::format("one of version {}, made by another release", version));
    }
    for (const Json& row : report.at("headline")) {
      const std::string key =
          row.at("method").get<std::string>() + " " + row.at("setting").get<std::string>();
      rows[key] = row.at("numbers").get<std::map<std::string, double>>();
    }
  } catch (const nlohmann::json::exception&) {
    throw InputError(name, "the report.json of an evaluation", "another file");
  }
  return rows;
}

}  // namespace

std::string report_json(const Evaluation& evaluation, const ReportInfo& info) {
  Json json = {{"version", report_version},
               {"symscene", info.version},
               {"dataset", info.dataset},
               {"date", info.date},
               {"made_with", info.made_with},
               {"headline", headline_json(evaluation.segmentation)},
               {"missed_objects", missed_objects_json(evaluation)},
               {"runtimes", runtimes_json(evaluation)},
               {"segmentation", to_json(evaluation.segmentation)},
               {"detection", to_json(evaluation.detection)},
               {"subsets", Json::object()},
               {"scenes", Json::array()}};
  for (const auto& [subset, sweeps] : evaluation.subsets) json["subsets"][subset] = to_json(sweeps);
  for (const SceneEvaluation& scene : evaluation.scenes) json["scenes"].push_back(to_json(scene));
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string report_difference(const std::string& report, const std::string& earlier,
                              const std::string& name) {
  const auto then = headline_numbers(earlier, name);
  const auto now = headline_numbers(report, "report");
  TextTable table{{"method", "metric", "then", "now", "difference"}};
  for (const auto& [method, numbers] : now) {
    if (!then.contains(method)) continue;
    for (const auto& [metric, value] : numbers) {
      const auto old = then.at(method).find(metric);
      if (old == then.at(method).end()) continue;
      table.push_back({method, metric, percent(old->second), percent(value),
                       fmt::format("{:+.1f}", 100.0 * (value - old->second))});
    }
  }
  return aligned(table, 2);
}

}  // namespace symscene
