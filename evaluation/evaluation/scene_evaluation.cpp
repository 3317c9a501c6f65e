#include "symscene/evaluation/scene_evaluation.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "assignment.hpp"
#include "core/evenly_spaced.hpp"
#include "core/parallel.hpp"
#include "detection_sweeps.hpp"
#include "proposals/object_proposals.hpp"
#include "setting_counts.hpp"
#include "sweep_settings.hpp"
#include "symmetry/object_symmetry.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

const std::vector<Metric> mask_metrics = {Metric::masks_90, Metric::masks_75, Metric::masks_50};

/// Without the rotational stream there are no axes to evaluate.
std::vector<Metric> pipeline_metrics(bool rotational) {
  if (rotational) return {all_metrics.begin(), all_metrics.end()};
  std::vector<Metric> metrics = mask_metrics;
  metrics.insert(metrics.end(), {Metric::planes, Metric::planes_near});
  return metrics;
}

/// The bounds of table 4.2, in the order of the settings.
const std::vector<std::string> segmentation_parameters = {"refl_symmetry", "refl_occlusion",
                                                          "rot_symmetry", "rot_occlusion"};

std::vector<std::vector<double>> segmentation_grid(bool rotational) {
  const auto of_planes =
      std::vector{evenly_spaced(0.1, 0.6, 0.1), evenly_spaced(0.005, 0.045, 0.01)};
  if (!rotational) return all_settings(of_planes);
  return all_settings({of_planes[0], of_planes[1], evenly_spaced(0.01, 0.03, 0.01),
                       evenly_spaced(0.01, 0.015, 0.005)});
}

PipelineOptions at_setting(PipelineOptions options, const std::vector<double>& setting) {
  options.selection.by_score = false;
  options.reflectional_segmentation.bounds.max_symmetry = setting[0];
  options.reflectional_segmentation.bounds.max_occlusion = setting[1];
  if (setting.size() < 4) return options;
  options.rotational_segmentation.bounds.max_symmetry = setting[2];
  options.rotational_segmentation.bounds.max_occlusion = setting[3];
  return options;
}

PipelineOptions within_bounds(PipelineOptions options) {
  options.selection.by_score = false;
  return options;
}

/// Table 4.2 over the proposals of one variant of the pipeline.
Sweep segmentation_sweep(const char* method, const SceneProposals& proposals,
                         const CountingContext& context, const PipelineOptions& options) {
  Sweep sweep;
  sweep.method = method;
  sweep.parameters = segmentation_parameters;
  if (!options.rotational_stream) sweep.parameters.resize(2);
  sweep.settings = segmentation_grid(options.rotational_stream);
  sweep.metrics = pipeline_metrics(options.rotational_stream);
  sweep.counts.resize(sweep.settings.size());
  parallel_for_each(sweep.settings.size(), [&](std::size_t k) {
    const SegmentationResult result =
        choose_objects(proposals, at_setting(options, sweep.settings[k]));
    sweep.counts[k] = context.count(result.objects);
  });
  return sweep;
}

/// The proposals that each least score selects. The candidates for their symmetries do not depend
/// on the setting and are computed once per proposal.
struct ScoredObjects {
  std::vector<std::vector<std::size_t>> chosen;  ///< per least score, indices of proposals
  std::map<std::size_t, SymmetryCandidates> symmetries;
};

ScoredObjects scored_objects(const SceneProposals& proposals, const PipelineOptions& options,
                             const std::vector<double>& scores) {
  ScoredObjects objects;
  for (const double score : scores) {
    SelectionOptions selection = options.selection;
    selection.min_score = score;
    std::vector<Rejection> rejected;
    objects.chosen.push_back(probable_proposals(proposals, selection, rejected));
    for (const std::size_t chosen : objects.chosen.back()) objects.symmetries[chosen];
  }
  std::vector<std::pair<std::size_t, SymmetryCandidates*>> unsearched;
  for (auto& [chosen, found] : objects.symmetries) unsearched.emplace_back(chosen, &found);
  parallel_for_each(unsearched.size(), [&](std::size_t k) {
    *unsearched[k].second = symmetry_candidates(
        proposals.observed(),
        searched_object(proposals, unsearched[k].first, options.object_symmetry),
        options.symmetry_search_options());
  });
  return objects;
}

/// The least probabilities of objects and of their symmetries, over all proposals.
Sweep score_sweep(const SceneProposals& proposals, const CountingContext& context,
                  const PipelineOptions& options) {
  const std::vector<double> scores = evenly_spaced(0.05, 0.95, 0.05);
  const std::vector<double> probabilities = evenly_spaced(0.1, 0.7, 0.1);
  Sweep sweep;
  sweep.method = scored_method;
  sweep.parameters = {"min_score", "min_symmetry_probability"};
  sweep.settings = all_settings({scores, probabilities});
  sweep.metrics = pipeline_metrics(options.rotational_stream);
  sweep.counts.resize(sweep.settings.size());
  const ScoredObjects objects = scored_objects(proposals, options, scores);
  parallel_for_each(scores.size(), [&](std::size_t k) {
    SettingCounts* const own = &sweep.counts[k * probabilities.size()];
    for (std::size_t p = 0; p < probabilities.size(); ++p) {
      ObjectSymmetryOptions bounds = options.object_symmetry;
      bounds.min_axis_probability = bounds.min_plane_probability = probabilities[p];
      std::vector<SceneObject> chosen;
      for (const std::size_t i : objects.chosen[k])
        chosen.push_back(probable_object(proposals.objects[i], objects.symmetries.at(i), bounds));
      own[p] = p == 0 ? context.count(chosen) : context.recount(own[0], chosen);
    }
  });
  return sweep;
}

Sweep baseline_sweep(const BaselineMethod& baseline, const PointCloud& cloud,
                     const CountingContext& context, StageTimer& timer) {
  const BaselineSweep found = timer.time("baselines", [&] { return baseline(cloud); });
  if (found.values.size() != found.masks.size()) {
    throw InputError(found.method, "masks for each of its values",
                     fmt::format("{} for {}", found.masks.size(), found.values.size()));
  }
  Sweep sweep;
  sweep.method = found.method;
  sweep.parameters = {found.parameter};
  sweep.settings = all_settings({found.values});
  sweep.metrics = mask_metrics;
  sweep.counts.resize(found.masks.size());
  parallel_for_each(found.masks.size(), [&](std::size_t k) {
    sweep.counts[k] = context.count(found.masks[k], {}, {});
    context.count_pixels(found.masks[k], sweep.counts[k]);
  });
  sweep.seconds = found.seconds;
  return sweep;
}

/// An empty scene, such as that of a sweep on which tracking failed, has no proposals.
SceneProposals proposals_of(const Scene& scene, const PipelineOptions& options,
                            const StageTimer::OnBegin& on_begin) {
  return scene.cloud.empty() ? SceneProposals{} : propose_objects(scene, options, on_begin);
}

/// A scene to evaluate.
struct Job {
  const Scene& scene;
  const SceneTruth& truth;
  const EvaluationOptions& options;
  const StageTimer::OnBegin& on_begin;
  const std::optional<LabeledView>& view;
};

/// The pipeline with the given options: its sweeps, the outcome of every object and the times.
void evaluate_given(const Job& job, StageTimer& timer, SceneEvaluation& evaluation) {
  const Scene& scene = job.scene;
  const SceneTruth& truth = job.truth;
  const EvaluationOptions& options = job.options;
  const StageTimer::OnBegin& on_begin = job.on_begin;
  const SceneProposals proposals = proposals_of(scene, options.pipeline, on_begin);
  const SegmentationResult result =
      timer.time("choice", [&] { return choose_objects(proposals, options.pipeline); });
  evaluation.timings = proposals.timings;
  evaluation.timings.push_back(timer.stages().back());
  evaluation.returned = result.objects.size();
  // A result's warnings begin with the scene's, but an empty scene has no result of its own.
  evaluation.warnings = scene.cloud.empty() ? scene.warnings : result.warnings;
  if (on_begin) on_begin("sweep");
  const CountingContext context(scene, truth, proposals.cloud, options, job.view);
  Sweep scored = score_sweep(proposals, context, options.pipeline);
  const bool full = options.pipeline.rotational_stream;
  Sweep bounded = segmentation_sweep(full ? full_method : reflectional_method, proposals, context,
                                     options.pipeline);
  bounded.at_default =
      context.count_with_pixels(choose_objects(proposals, within_bounds(options.pipeline)).objects);
  Sweep& given = options.pipeline.selection.by_score ? scored : bounded;
  given.at_default = context.count_with_pixels(result.objects);
  for (const StageTime& time : evaluation.timings) given.seconds += time.seconds;
  evaluation.segmentation.push_back(std::move(scored));
  evaluation.segmentation.push_back(std::move(bounded));
  evaluation.objects = object_outcomes(truth, context.masks(), proposals, result);
  for (const BaselineMethod& baseline : options.baselines)
    evaluation.segmentation.push_back(baseline_sweep(baseline, proposals.cloud, context, timer));
}

/// A variant of the pipeline without its rotational stream (section 4.5.1), at its place among the
/// variants.
void evaluate_variant(const Job& job, const char* method, const PipelineOptions& pipeline,
                      std::ptrdiff_t place, SceneEvaluation& evaluation) {
  const SceneProposals proposals = proposals_of(job.scene, pipeline, job.on_begin);
  const CountingContext context(job.scene, job.truth, proposals.cloud, job.options, job.view);
  Sweep sweep = segmentation_sweep(method, proposals, context, pipeline);
  sweep.at_default =
      context.count_with_pixels(choose_objects(proposals, within_bounds(pipeline)).objects);
  evaluation.segmentation.insert(evaluation.segmentation.begin() + place, std::move(sweep));
}

void evaluate_reflectional_variants(const Job& job, SceneEvaluation& evaluation) {
  PipelineOptions pipeline = job.options.pipeline;
  pipeline.rotational_stream = false;
  pipeline.planes_of_surfaces = true;
  pipeline.planes_of_curves = false;
  evaluate_variant(job, reflectional_method, pipeline, 2, evaluation);
  pipeline.planes_of_surfaces = false;
  pipeline.planes_of_curves = true;
  evaluate_variant(job, curve_method, pipeline, 3, evaluation);
}

}  // namespace

void require_usable_truth(const Scene& scene, const SceneTruth& truth) {
  std::vector<Index> owner(scene.cloud.size(), unlabeled);
  for (std::size_t k = 0; k < truth.objects.size(); ++k) {
    const TrueObject& object = truth.objects[k];
    const std::string where = fmt::format("ground truth of object {} ({})", k, object.name);
    for (const Index i : object.points) {
      if (i >= owner.size()) {
        throw InputError(where, fmt::format("indices below {}", owner.size()),
                         fmt::format("{}", i));
      }
      if (owner[i] != unlabeled) {
        throw InputError(where, "points that no other object has",
                         fmt::format("point {} of object {} too", i, owner[i]));
      }
      owner[i] = static_cast<Index>(k);
    }
  }
}

SceneEvaluation evaluate_scene(const Scene& scene, const SceneTruth& truth,
                               const EvaluationOptions& options,
                               const StageTimer::OnBegin& on_begin,
                               const std::optional<LabeledView>& view) {
  options.validate();
  require_usable_truth(scene, truth);
  SceneEvaluation evaluation;
  StageTimer timer(on_begin);
  const Job job{scene, truth, options, on_begin, view};
  evaluate_given(job, timer, evaluation);
  if (options.reflectional_only && options.pipeline.rotational_stream)
    evaluate_reflectional_variants(job, evaluation);
  evaluation.detection = detection_sweeps(scene, truth, options.pipeline, on_begin);
  return evaluation;
}

}  // namespace symscene
