// Fits the models object_alone and object_among_others to datasets with ground truth
// (benchmarks/README.md).
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "fitting.hpp"
#include "proposals/object_score.hpp"
#include "proposals/selection.hpp"
#include "symscene/evaluation/mask_metrics.hpp"

namespace symscene::bench {
namespace {

struct Arguments : FitArguments {
  double partial_target = 0.35;  ///< target of a proposal with an IoU from 0.75 to 0.9
  /// Weights of the cut's confidence in the combined score that are compared.
  std::vector<double> confidence_weights{ObjectScoreOptions{}.confidence_weight};
};

/// The proposals of a scene and its ground truth.
struct ScoredScene {
  std::size_t dataset = 0;
  std::size_t number = 0;  ///< the same for a scene and its noisy copies
  std::vector<PointIndices> truth;
  std::vector<SceneObject> objects;
  std::vector<Sample> samples;      ///< one per object
  std::vector<double> confidences;  ///< of the cuts, one per object
  std::optional<SharedCounts> shared;
};

struct ObjectModels {
  TreeModel alone;
  TreeModel among_others;
};

double target_of(const std::vector<PointIndices>& truth, const PointIndices& points,
                 double partial_target) {
  double best = 0.0;
  for (const PointIndices& mask : truth)
    best = std::max(best, intersection_over_union(mask, points));
  return best > 0.9 ? 1.0 : best > 0.75 ? partial_target : 0.0;
}

ScoredScene scored(const FitScene& given, const Arguments& arguments) {
  const LoadedEntry loaded = load(given);
  ScoredScene scene;
  scene.dataset = given.dataset;
  scene.number = given.number;
  SceneProposals proposals = propose_objects(loaded.scene, pipeline_options(arguments));
  scene.truth = transfer_masks(loaded.scene.cloud, loaded.truth, proposals.cloud);
  for (ObjectProposal& proposal : proposals.objects) {
    scene.samples.push_back(sample_of(
        proposal.features, target_of(scene.truth, proposal.object.points, arguments.partial_target),
        arguments.without));
    scene.confidences.push_back(proposal.features.confidence);
    scene.objects.push_back(std::move(proposal.object));
  }
  std::vector<const PointIndices*> sets;
  for (const SceneObject& object : scene.objects) sets.push_back(&object.points);
  scene.shared.emplace(sets);
  return scene;
}

/// Metrics at one threshold of the score.
struct Counts {
  DetectionCounts over_90, over_75;
};

Counts count(const std::vector<ScoredScene>& scenes, const SelectionOptions& options) {
  Counts counts;
  for (const ScoredScene& scene : scenes) {
    std::vector<Rejection> rejected;
    std::vector<PointIndices> masks;
    for (const SceneObject& object : select_probable(scene.objects, options, rejected))
      masks.push_back(object.points);
    const OverlapMatrix overlaps = overlap_matrix(scene.truth, masks);
    counts.over_90 += mask_detections(overlaps, 0.9);
    counts.over_75 += mask_detections(overlaps, 0.75);
  }
  return counts;
}

void print_curve(const std::vector<ScoredScene>& scenes) {
  fmt::print("min score   P .9   R .9   F .9   F .75\n");
  for (int k = 1; k <= 12; ++k) {
    SelectionOptions options;
    options.min_score = 0.05 * k;
    const Counts counts = count(scenes, options);
    fmt::print("{:9.2f}  {:.3f}  {:.3f}  {:.3f}   {:.3f}\n", options.min_score,
               counts.over_90.precision(), counts.over_90.recall(), counts.over_90.f_measure(),
               counts.over_75.f_measure());
  }
}

void print_ceiling(const std::vector<ScoredScene>& scenes) {
  std::size_t truth = 0, proposals = 0, reached = 0;
  for (const ScoredScene& scene : scenes) {
    truth += scene.truth.size();
    proposals += scene.objects.size();
    for (const PointIndices& mask : scene.truth) {
      reached += std::any_of(scene.objects.begin(), scene.objects.end(),
                             [&](const auto& object) {
                               return intersection_over_union(mask, object.points) > 0.9;
                             })
                     ? 1
                     : 0;
    }
  }
  fmt::print("{} scenes, {} objects, {} of them proposed (IoU > 0.9), {} proposals\n",
             scenes.size(), truth, reached, proposals);
}

std::vector<double> estimates(const TreeModel& alone, const ScoredScene& scene) {
  std::vector<double> values;
  for (const Sample& sample : scene.samples) values.push_back(alone.probability(sample.features));
  return values;
}

/// The samples with the relations between the proposals, given their estimates.
std::vector<Sample> samples_among_others(const ScoredScene& scene,
                                         const std::vector<double>& estimates) {
  std::vector<Sample> samples = scene.samples;
  const std::vector<ProposalContext> contexts = proposal_contexts(*scene.shared, estimates);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto values = values_of(contexts[k]);
    samples[k].features.insert(samples[k].features.end(), values.begin(), values.end());
  }
  return samples;
}

void append(std::vector<Sample>& samples, const std::vector<Sample>& more) {
  samples.insert(samples.end(), more.begin(), more.end());
}

/// The second model is fitted to out-of-fold estimates of the first, as it will see them on new
/// scenes.
ObjectModels fit(const std::vector<const ScoredScene*>& scenes, const FitArguments& arguments) {
  constexpr std::size_t folds = 4;
  std::vector<std::optional<TreeModel>> alone(folds + 1);  // the last one is fitted to all scenes
  parallel_for_each(alone.size(), [&](std::size_t fold) {
    std::vector<Sample> samples;
    for (const ScoredScene* scene : scenes) {
      if (scene->number % folds != fold) append(samples, scene->samples);
    }
    alone[fold].emplace(
        fit_model(training_set<ObjectFeatures>("object_alone", arguments, std::move(samples)),
                  arguments.boosting));
  });
  std::vector<Sample> samples;
  for (const ScoredScene* scene : scenes)
    append(samples, samples_among_others(*scene, estimates(*alone[scene->number % folds], *scene)));
  return {*alone[folds], fit_model(training_set<ObjectFeatures, ProposalContext>(
                                       "object_among_others", arguments, std::move(samples)),
                                   arguments.boosting)};
}

void rescore(const ObjectModels& models, double weight, ScoredScene& scene) {
  const std::vector<Sample> samples = samples_among_others(scene, estimates(models.alone, scene));
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    scene.objects[k].score = combined_score(models.among_others.probability(samples[k].features),
                                            scene.confidences[k], weight);
  }
}

using Scenes = std::vector<ScoredScene>;

Scenes of_dataset(const Scenes& scenes, std::size_t dataset) {
  Scenes own;
  std::copy_if(scenes.begin(), scenes.end(), std::back_inserter(own),
               [&](const ScoredScene& scene) { return scene.dataset == dataset; });
  return own;
}

/// Scores each dataset with models fitted to the others.
void cross_validate(Scenes& scenes, const Arguments& arguments) {
  const auto models = fit_without_each<ObjectModels>(arguments, [&](std::size_t left_out) {
    std::vector<const ScoredScene*> others;
    for (const ScoredScene& scene : scenes) {
      if (scene.dataset != left_out) others.push_back(&scene);
    }
    return fit(others, arguments);
  });
  for (const double weight : arguments.confidence_weights) {
    for (ScoredScene& scene : scenes) rescore(*models[scene.dataset], weight, scene);
    fmt::print("each dataset scored by models of the others, confidence weight {}:\n", weight);
    print_curve(scenes);
    for (std::size_t d = 0; d < arguments.datasets.size(); ++d) {
      fmt::print("{}, confidence weight {}:\n", arguments.datasets[d].filename().string(), weight);
      print_curve(of_dataset(scenes, d));
    }
  }
}

void run(const Arguments& arguments) {
  Scenes scenes = extract_all<ScoredScene>(
      arguments, [&](const FitScene& scene) { return scored(scene, arguments); });
  print_ceiling(scenes);
  fmt::print("with the current models:\n");
  print_curve(scenes);
  if (arguments.datasets.size() > 1) cross_validate(scenes, arguments);
  std::vector<const ScoredScene*> all;
  for (const ScoredScene& scene : scenes) all.push_back(&scene);
  const ObjectModels models = fit(all, arguments);
  for (const TreeModel* model : {&models.alone, &models.among_others}) {
    print_split_counts(*model);
    write_model(arguments, *model);
  }
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{"Fits the probability that a proposal is an object to datasets with ground truth."};
  symscene::bench::add_fit_options(app, arguments);
  app.add_option("--partial-target", arguments.partial_target, "target for an IoU from 0.75 to 0.9")
      ->capture_default_str();
  app.add_option("--confidence-weights", arguments.confidence_weights,
                 "weights of the cut's confidence in the combined score, to compare");
  return symscene::bench::run_fit(app, argc, argv, arguments,
                                  [&] { symscene::bench::run(arguments); });
}
