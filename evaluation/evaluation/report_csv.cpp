#include <algorithm>

#include <fmt/format.h>

#include "sweep_settings.hpp"
#include "symscene/evaluation/report.hpp"

namespace symscene {
namespace {

/// A field of RFC 4180, quoted if necessary.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// An empty field for a share of nothing.
std::string share(double value, std::size_t whole) {
  return whole == 0 ? "" : fmt::format("{:.6f}", value);
}

void add_lines(const std::string& subset, const Sweep& sweep, const std::string& setting,
               const SettingCounts& counts, std::string& csv) {
  for (const Metric metric : sweep.metrics) {
    if (!sweep.has(metric)) continue;
    const DetectionCounts& detections = counts.detections(metric);
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", field(sweep.method), field(subset),
                       metric_name(metric), field(setting), detections.correct, detections.found,
                       detections.ground_truth, share(detections.precision(), detections.found),
                       share(detections.recall(), detections.ground_truth),
                       share(detections.f_measure(), detections.found + detections.ground_truth));
  }
}

void add_sweeps(const std::string& subset, const std::vector<Sweep>& sweeps, std::string& csv) {
  for (const Sweep& sweep : sweeps) {
    if (sweep.at_default) add_lines(subset, sweep, "default", *sweep.at_default, csv);
    for (std::size_t k = 0; k < sweep.settings.size(); ++k)
      add_lines(subset, sweep, setting_text(sweep, k), sweep.counts[k], csv);
  }
}

void add_pixel_line(const std::string& subset, const Sweep& sweep, const std::string& setting,
                    const SettingCounts& counts, std::string& csv) {
  if (counts.images == 0) return;
  const SegmentationMetrics mean = counts.pixels.mean(counts.images);
  csv += fmt::format("{},{},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n",
                     field(sweep.method), field(subset), field(setting), counts.images,
                     mean.overlap_precision, mean.overlap_recall, mean.overlap_f,
                     mean.boundary_precision, mean.boundary_recall, mean.boundary_f, mean.found_75);
}

void add_pixels(const std::string& subset, const std::vector<Sweep>& sweeps, std::string& csv) {
  for (const Sweep& sweep : sweeps) {
    if (sweep.at_default) add_pixel_line(subset, sweep, "default", *sweep.at_default, csv);
    for (std::size_t k = 0; k < sweep.settings.size(); ++k)
      add_pixel_line(subset, sweep, setting_text(sweep, k), sweep.counts[k], csv);
  }
}

double total_seconds(const std::vector<StageTime>& times) {
  double sum = 0.0;
  for (const StageTime& time : times) sum += time.seconds;
  return sum;
}

/// The stages of all scenes, in order of first appearance.
std::vector<std::string> stage_names(const Evaluation& evaluation) {
  std::vector<std::string> names;
  for (const SceneEvaluation& scene : evaluation.scenes) {
    for (const StageTime& time : scene.timings) {
      if (std::find(names.begin(), names.end(), time.stage) == names.end())
        names.push_back(time.stage);
    }
  }
  return names;
}

double seconds_of(const SceneEvaluation& scene, const std::string& stage) {
  double sum = 0.0;
  for (const StageTime& time : scene.timings) sum += time.stage == stage ? time.seconds : 0.0;
  return sum;
}

}  // namespace

std::string curves_csv(const Evaluation& evaluation) {
  std::string csv = "method,subset,metric,setting,correct,found,truth,precision,recall,f\n";
  add_sweeps("", evaluation.segmentation, csv);
  add_sweeps("", evaluation.detection, csv);
  for (const auto& [subset, sweeps] : evaluation.subsets) add_sweeps(subset, sweeps, csv);
  return csv;
}

std::string pixels_csv(const Evaluation& evaluation) {
  std::string csv =
      "method,subset,setting,images,overlap_precision,overlap_recall,overlap_f,"
      "boundary_precision,boundary_recall,boundary_f,f_75\n";
  add_pixels("", evaluation.segmentation, csv);
  for (const auto& [subset, sweeps] : evaluation.subsets) add_pixels(subset, sweeps, csv);
  return csv;
}

std::string objects_csv(const Evaluation& evaluation) {
  std::string csv =
      "scene,subset,object,kind,points,small,best_iou,best_proposal_iou,outcome,reason,symmetries,"
      "symmetries_met\n";
  for (const SceneEvaluation& scene : evaluation.scenes) {
    for (std::size_t k = 0; k < scene.objects.size(); ++k) {
      const ObjectOutcome& outcome = scene.objects[k];
      csv += fmt::format("{},{},{},{},{},{},{:.6f},{:.6f},{},{},{},{}\n", field(scene.name),
                         field(scene.subset), k, field(outcome.kind), outcome.points,
                         outcome.is_small ? 1 : 0, outcome.best_overlap,
                         outcome.best_proposal_overlap, outcome_name(outcome.outcome),
                         field(outcome.reason), outcome.symmetries, outcome.symmetries_met);
    }
  }
  return csv;
}

std::string scenes_csv(const Evaluation& evaluation) {
  const std::vector<std::string> stages = stage_names(evaluation);
  std::string csv = "scene,subset,objects,small,lost,found,returned,mean_iou,seconds";
  for (const std::string& stage : stages) csv += "," + field(stage);
  csv += "\n";
  for (const SceneEvaluation& scene : evaluation.scenes) {
    OutcomeCounts counts;
    for (const ObjectOutcome& outcome : scene.objects) counts.add(outcome);
    const auto small = std::count_if(scene.objects.begin(), scene.objects.end(),
                                     [](const ObjectOutcome& outcome) { return outcome.is_small; });
    csv += fmt::format("{},{},{},{},{},{},{},{:.6f},{:.6f}", field(scene.name), field(scene.subset),
                       counts.objects, small, counts.count(Outcome::lost),
                       counts.count(Outcome::found), scene.returned, counts.mean_overlap(),
                       total_seconds(scene.timings));
    for (const std::string& stage : stages) csv += fmt::format(",{:.6f}", seconds_of(scene, stage));
    csv += "\n";
  }
  return csv;
}

}  // namespace symscene
