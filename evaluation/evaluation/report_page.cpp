#include <algorithm>

#include <fmt/format.h>

#include "core/base64.hpp"
#include "curve_plot.hpp"
#include "evaluation/markup.hpp"
#include "evaluation/report_parts.hpp"
#include "paired_comparison.hpp"
#include "report_tables.hpp"

namespace symscene {
namespace {

constexpr std::size_t most_worst_scenes = 15;
constexpr std::size_t most_failures = 10;

/// The curves of the methods that the metric applies to, each in its own colour.
std::string figure(const std::string& caption, const std::vector<const Sweep*>& candidates,
                   Metric metric) {
  std::vector<const Sweep*> shown;
  std::vector<std::size_t> colors;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (!candidates[k]->has(metric)) continue;
    shown.push_back(candidates[k]);
    colors.push_back(k % report_colors);
  }
  return shown.empty() ? "" : curve_figure(caption, shown, colors, metric);
}

std::string figures(const Evaluation& evaluation) {
  std::vector<const Sweep*> sweeps;
  for (const Sweep& sweep : evaluation.segmentation) sweeps.push_back(&sweep);
  std::string html = "<div class=\"figures\">\n";
  html += figure("Masks, IoU > 0.9", sweeps, Metric::masks_90);
  html += figure("Masks, IoU > 0.75", sweeps, Metric::masks_75);
  html += figure("Masks, IoU > 0.5", sweeps, Metric::masks_50);
  return html + "</div>\n";
}

/// Empty where no method has a mask and nothing was to be found.
std::string mask_curves(const Evaluation& evaluation) {
  const std::string shown = figures(evaluation);
  if (shown.find("<figure>") == std::string::npos) return "";
  return report_section(
             "Masks",
             "Precision and recall over the settings of each method: the least probabilities of "
             "SymScene, the bounds of table 4.2, the parameters of the baselines. Dots are "
             "settings, lines their envelopes, stars the best F, rings the default; dashed curves "
             "are of constant F: 20, 40, 60 and 80.") +
         shown;
}

/// Empty where the ground truth has no symmetries.
std::string symmetry_figures(const Evaluation& evaluation) {
  if (evaluation.outcomes.symmetries == 0) return "";
  std::vector<const Sweep*> sweeps;
  for (const Sweep& sweep : evaluation.segmentation) sweeps.push_back(&sweep);
  std::string html = report_section(
      "Symmetries",
      "Rotation axes and mirror planes within 10° and 10 cm, and within 10° and 1 cm, of "
      "the ground truth: before segmentation (table 3.1) and of the returned objects. "
      "Planes through a rotation axis of their object and weak symmetries count as "
      "neither right nor wrong.");
  for (const Sweep& sweep : evaluation.detection) sweeps.push_back(&sweep);
  html += "<div class=\"figures small\">\n";
  html += figure("Axes, 10° and 10 cm", sweeps, Metric::axes);
  html += figure("Planes, 10° and 10 cm", sweeps, Metric::planes);
  html += figure("Axes, 10° and 1 cm", sweeps, Metric::axes_near);
  html += figure("Planes, 10° and 1 cm", sweeps, Metric::planes_near);
  return html + "</div>\n";
}

std::string missed_objects(const Evaluation& evaluation) {
  std::string html = report_section(
      "Missed objects",
      "True objects at the default options: found (IoU &gt; 0.9); not proposed, as none of their "
      "symmetries was detected; proposed but wrongly segmented (no proposal with IoU &gt; 0.9); "
      "rejected by a bound or in the selection of objects; or lost before segmentation, as the "
      "scene's cloud has no point of them. Every labelled object counts.");
  html += report_table(missed_object_table(evaluation), "l1 total");
  const TextTable reasons = reason_table(evaluation);
  if (reasons.size() > 1) html += "<br/>\n" + report_table(reasons, "l2");
  return html;
}

/// A missed object and its scene.
struct Failure {
  const SceneEvaluation* scene;
  const ObjectOutcome* outcome;
};

/// The missed objects that least was found of, the larger ones first.
std::vector<Failure> worst_failures(const Evaluation& evaluation) {
  std::vector<Failure> failures;
  for (const SceneEvaluation& scene : evaluation.scenes) {
    for (const ObjectOutcome& outcome : scene.objects) {
      if (!outcome.picture.empty() && !outcome.is_small) failures.push_back({&scene, &outcome});
    }
  }
  std::stable_sort(failures.begin(), failures.end(), [](const Failure& a, const Failure& b) {
    if (a.outcome->best_overlap != b.outcome->best_overlap)
      return a.outcome->best_overlap < b.outcome->best_overlap;
    return a.outcome->points > b.outcome->points;
  });
  failures.resize(std::min(failures.size(), most_failures));
  return failures;
}

std::string failure_figure(const Failure& failure) {
  const ObjectOutcome& outcome = *failure.outcome;
  const std::vector<std::uint8_t> bytes(outcome.picture.begin(), outcome.picture.end());
  const std::string what = fmt::format("{} in scene {}", escape_markup(outcome.kind),
                                       escape_markup(failure.scene->name));
  return fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"/>\n<figcaption>{0}"
      "<small>{2} ({3}), best IoU {4:.2f}. Instead: {5}.</small></figcaption></figure>\n",
      what, base64(bytes), outcome_name(outcome.outcome), escape_markup(outcome.reason),
      outcome.best_overlap, escape_markup(outcome.instead));
}

/// Empty if nothing was missed that can be shown.
std::string failure_pictures(const Evaluation& evaluation) {
  const std::vector<Failure> failures = worst_failures(evaluation);
  if (failures.empty()) return "";
  std::string html = report_section(
      "Worst failures",
      "Missed objects by their best IoU with a returned mask, without those of few points. Red: "
      "points of the object in no mask that has a tenth of it; green, yellow, violet: those in "
      "such masks, a colour each; blue: other points of those masks; grey: the rest of the scene.");
  html += "<div class=\"failures\">\n";
  for (const Failure& failure : failures) html += failure_figure(failure);
  return html + "</div>\n";
}

/// Empty where there is nothing to compare.
std::string paired_comparison(const Evaluation& evaluation) {
  const TextTable table = paired_table(evaluation);
  if (table.size() == 1) return "";
  const std::string text = fmt::format(
      "F of masks at 0.9 in percent: that of {} at its default minus that of each method in the "
      "same scenes, with the interval that holds 95 % of the differences over scenes drawn anew "
      "(2,000 draws). An interval that does not contain 0 tells methods apart. Methods without a "
      "default "
      "have the setting that is best in hindsight, which favours them.",
      escape_markup(compared_method(evaluation)));
  return report_section("Paired comparison", text.c_str()) + report_table(table, "l2");
}

/// Empty where all objects are of one kind.
std::string kinds(const Evaluation& evaluation) {
  if (evaluation.kinds.size() < 2) return "";
  return report_section("Kinds of objects",
                        "At the default options; symmetries within 10° and 1 cm.") +
         report_table(kind_table(evaluation), "l1");
}

std::string pixels(const std::vector<Sweep>& sweeps) {
  const TextTable table = pixel_table(sweeps);
  if (table.size() == 1) return "";
  return report_section(
             "Pixels",
             "Label images against those of the dataset, as UOIS-Net (Xie et al. 2020) reports "
             "them, in percent: precision, recall and F of overlap and of boundaries after an "
             "assignment of masks to objects for the greatest sum of F, and the share of "
             "objects with an overlap F over 0.75; means over images. The best setting is that "
             "with the greatest overlap F.") +
         report_table(table, "l2");
}

std::string subsets(const Evaluation& evaluation) {
  std::string html;
  for (const auto& [subset, sweeps] : evaluation.subsets) {
    html += fmt::format("<h2>Subset {}</h2>\n", escape_markup(subset));
    html += report_table(without_empty_columns(headline_table(sweeps)), "l2");
    const TextTable of_pixels = pixel_table(sweeps);
    if (of_pixels.size() > 1) html += "<br/>\n" + report_table(of_pixels, "l2");
  }
  return html;
}

std::string scenes(const Evaluation& evaluation) {
  const TextTable worst = worst_scene_table(evaluation, most_worst_scenes);
  if (worst.size() == 1) return report_section("Worst scenes", "None: every object was found.");
  return report_section("Worst scenes",
                        "At the default options, by the F of their masks at IoU &gt; 0.9.") +
         report_table(worst, "l1 last");
}

std::string opening(const Evaluation& evaluation, const ReportInfo& info) {
  return fmt::format("<h1>Evaluation on {}</h1>\n<p>{}. {}, symscene {}. {}</p>\n",
                     escape_markup(info.dataset), what_was_evaluated(evaluation),
                     escape_markup(info.date), escape_markup(info.version),
                     escape_markup(info.made_with));
}

}  // namespace

std::string report_page(const Evaluation& evaluation, const ReportInfo& info) {
  std::string html = report_head(info.dataset + " – evaluation") + opening(evaluation, info);
  html += report_section(
      "Headline",
      "F in percent: of masks above an IoU, of symmetries within 10° and 10 cm or 1 cm. "
      "“Default” has the options of the run; “best” has the greatest F of each metric "
      "over all settings, and all else at the best setting for masks at 0.9.");
  html += report_table(without_empty_columns(headline_table(evaluation.segmentation)), "l2") +
          "<br/>\n";
  html += report_table(default_table(evaluation.segmentation), "l1 last");
  html += paired_comparison(evaluation) + pixels(evaluation.segmentation);
  html += mask_curves(evaluation) + symmetry_figures(evaluation);
  html += missed_objects(evaluation);
  html += failure_pictures(evaluation) + kinds(evaluation);
  html += report_section(
      "Runtime",
      "Mean wall time over scenes by number of objects, without completion, as measured in "
      "this run; the time of a baseline is that of a run at the middle of its settings.");
  html += report_table(runtime_table(evaluation), "l1") + "<br/>\n";
  html += report_table(method_time_table(evaluation), "l1");
  html += subsets(evaluation) + scenes(evaluation);
  return html + report_end;
}

}  // namespace symscene
