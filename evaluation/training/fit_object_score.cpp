// Fits the probability that a proposal is an object to datasets with truth: see README.md.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/parallel.hpp"
#include "io/atomic_file.hpp"
#include "proposals/object_score.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "symscene/proposals/selection.hpp"
#include "tree_fitting.hpp"

namespace symscene::bench {
namespace {

struct Arguments : FitArguments {
  double half_right = 0.35;          ///< target of a proposal with an IoU between 0.75 and 0.9
  std::vector<double> beliefs{0.6};  ///< in the confidence of cuts, to compare
};

/// What a scene proposes, and what it should have.
struct ScoredScene {
  std::size_t dataset = 0;
  std::size_t number = 0;  ///< alike for a scene and its noisy copies
  std::vector<PointIndices> truth;
  std::vector<SceneObject> objects;
  std::vector<Sample> samples;      ///< one an object
  std::vector<double> confidences;  ///< of the cuts, one an object
  std::optional<SharedCounts> shared;
};

/// Both tables of object_score.cpp.
struct Model {
  BoostedTrees alone;
  BoostedTrees among_others;
};

double target_of(const std::vector<PointIndices>& truth, const PointIndices& points,
                 double half_right) {
  double best = 0.0;
  for (const PointIndices& mask : truth)
    best = std::max(best, intersection_over_union(mask, points));
  return best > 0.9 ? 1.0 : best > 0.75 ? half_right : 0.0;
}

ScoredScene scored(const FitScene& given, const Arguments& arguments) {
  const LoadedEntry loaded = load(given);
  ScoredScene scene;
  scene.dataset = given.dataset;
  scene.number = given.number;
  SceneProposals proposals = propose_objects(loaded.scene);
  scene.truth = transfer_masks(loaded.scene.cloud, loaded.truth, proposals.cloud);
  for (ObjectProposal& proposal : proposals.objects) {
    scene.samples.push_back(sample_of(
        proposal.features, target_of(scene.truth, proposal.object.points, arguments.half_right),
        arguments.without));
    scene.confidences.push_back(proposal.features.confidence);
    scene.objects.push_back(std::move(proposal.object));
  }
  std::vector<const PointIndices*> sets;
  for (const SceneObject& object : scene.objects) sets.push_back(&object.points);
  scene.shared.emplace(sets);
  return scene;
}

std::vector<ScoredScene> load_all(const Arguments& arguments) {
  std::vector<ScoredScene> scenes;
  for (const FitScene& scene : fit_scenes(arguments)) {
    scenes.push_back(scored(scene, arguments));
    fmt::print(stderr, "\r{} scenes", scenes.size());
  }
  fmt::print(stderr, "\n");
  return scenes;
}

/// Counts at one least probability.
struct Counts {
  Score over_90, over_75;
};

Counts count(const std::vector<ScoredScene>& scenes, const SelectionOptions& options) {
  Counts counts;
  for (const ScoredScene& scene : scenes) {
    std::vector<Rejection> rejected;
    std::vector<PointIndices> masks;
    for (const SceneObject& object : select_probable(scene.objects, options, rejected))
      masks.push_back(object.points);
    const OverlapMatrix overlaps = overlap_matrix(scene.truth, masks);
    counts.over_90 += mask_score(overlaps, 0.9);
    counts.over_75 += mask_score(overlaps, 0.75);
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

std::vector<double> estimates(const BoostedTrees& alone, const ScoredScene& scene) {
  std::vector<double> values;
  for (const Sample& sample : scene.samples) values.push_back(alone.probability(sample.features));
  return values;
}

/// The samples with what the scene's other proposals say, by their estimates.
std::vector<Sample> samples_among_others(const ScoredScene& scene,
                                         const std::vector<double>& estimates) {
  std::vector<Sample> samples = scene.samples;
  const std::vector<ProposalContext> contexts = proposal_contexts(*scene.shared, estimates);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    ProposalContext::visit_fields(
        contexts[k], [&](const char*, double value) { samples[k].features.push_back(value); });
  }
  return samples;
}

void append(std::vector<Sample>& samples, const std::vector<Sample>& more) {
  samples.insert(samples.end(), more.begin(), more.end());
}

/// The trees that judge a proposal among others learn from estimates by trees that do not know its
/// scene, as they will get.
Model fit(const std::vector<const ScoredScene*>& scenes, const BoostingOptions& options) {
  constexpr std::size_t folds = 4;
  std::vector<BoostedTrees> models(folds + 1);  // the last one knows all
  parallel_for_each(models.size(), [&](std::size_t fold) {
    std::vector<Sample> samples;
    for (const ScoredScene* scene : scenes) {
      if (scene->number % folds != fold) append(samples, scene->samples);
    }
    models[fold] = fit_trees(samples, options);
  });
  std::vector<Sample> samples;
  for (const ScoredScene* scene : scenes)
    append(samples, samples_among_others(*scene, estimates(models[scene->number % folds], *scene)));
  return {models[folds], fit_trees(samples, options)};
}

void rescore(const Model& model, double belief, ScoredScene& scene) {
  const std::vector<Sample> samples = samples_among_others(scene, estimates(model.alone, scene));
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    scene.objects[k].score = combined_score(model.among_others.probability(samples[k].features),
                                            scene.confidences[k], belief);
  }
}

using Scenes = std::vector<ScoredScene>;

Scenes of_dataset(const Scenes& scenes, std::size_t dataset) {
  Scenes own;
  std::copy_if(scenes.begin(), scenes.end(), std::back_inserter(own),
               [&](const ScoredScene& scene) { return scene.dataset == dataset; });
  return own;
}

/// Every dataset with trees that were fitted to the others.
void cross_validate(Scenes& scenes, const Arguments& arguments) {
  std::vector<Model> models;
  for (std::size_t d = 0; d < arguments.datasets.size(); ++d) {
    std::vector<const ScoredScene*> others;
    for (const ScoredScene& scene : scenes) {
      if (scene.dataset != d) others.push_back(&scene);
    }
    models.push_back(fit(others, arguments.boosting));
  }
  for (const double belief : arguments.beliefs) {
    for (ScoredScene& scene : scenes) rescore(models[scene.dataset], belief, scene);
    fmt::print("each dataset scored by the others, belief {}:\n", belief);
    print_curve(scenes);
    for (std::size_t d = 0; d < arguments.datasets.size(); ++d) {
      fmt::print("{}, belief {}:\n", arguments.datasets[d].filename().string(), belief);
      print_curve(of_dataset(scenes, d));
    }
  }
}

void run(const Arguments& arguments) {
  std::vector<ScoredScene> scenes = load_all(arguments);
  print_ceiling(scenes);
  fmt::print("as it is:\n");
  print_curve(scenes);
  if (arguments.datasets.size() > 1) cross_validate(scenes, arguments);
  std::vector<const ScoredScene*> all;
  for (const ScoredScene& scene : scenes) all.push_back(&scene);
  const Model model = fit(all, arguments.boosting);
  print_use<ObjectFeatures>(model.alone);
  if (!arguments.output.empty()) {
    write_file_atomically(
        arguments.output,
        as_table(model.alone, "symscene_fit_object_score", "object_alone") +
            as_table(model.among_others, "symscene_fit_object_score", "object_among_others"));
  }
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{"Fits the probability that a proposal is an object to datasets with truth."};
  symscene::bench::add_fit_options(app, arguments);
  app.add_option("--half-right", arguments.half_right, "target for an IoU from 0.75 to 0.9")
      ->capture_default_str();
  app.add_option("--beliefs", arguments.beliefs, "in the confidence of cuts, to compare");
  return symscene::bench::run_fit(app, argc, argv, "symscene_fit_object_score",
                                  [&] { symscene::bench::run(arguments); });
}
