// Fits the probability that a plane is a mirror of an object to datasets with truth: see README.md.
#include <map>

#include "symscene/core/parallel.hpp"
#include "symscene/dataset/dataset_folder.hpp"
#include "symscene/evaluation/mask_measures.hpp"
#include "symscene/evaluation/symmetry_measures.hpp"
#include "symscene/io/atomic_file.hpp"
#include "symscene/pipeline/mask_symmetry.hpp"
#include "tree_fitting.hpp"

namespace symscene::bench {
namespace {

constexpr double min_object_score = 0.25;  // of a proposal whose planes are learned from
constexpr std::size_t most_objects = 40;   // a scene
constexpr double min_overlap = 0.4;        // of a proposal and the object whose mirror is right

struct CandidatePlane {
  ReflectionPlane plane;
  Sample sample;
  bool is_counted = true;  ///< right or wrong, not neither
  bool is_chosen = true;   ///< of an object that is chosen
};

struct PlanesOfScene {
  std::size_t dataset = 0;
  SceneTruth truth;
  std::vector<CandidatePlane> planes;
};

double best_overlap(const std::vector<PointIndices>& truth, const PointIndices& points) {
  double best = 0.0;
  for (const PointIndices& mask : truth)
    best = std::max(best, intersection_over_union(mask, points));
  return best;
}

CandidatePlane judged(const MeasuredPlane& measured, const SceneTruth& truth, double overlap,
                      const FitArguments& arguments) {
  SymmetryTolerance near, far;
  near.distance = 0.03;
  far.distance = 0.1;
  const ReflectionPlane planes[] = {measured.plane};
  const SymmetryMatch match = match_planes(truth, planes, near);
  const bool is_wrong = match.wrong > 0 && match_planes(truth, planes, far).wrong > 0;
  CandidatePlane candidate;
  candidate.plane = measured.plane;
  candidate.sample = sample_of(measured.measures, is_wrong ? 0.0 : 1.0, arguments.without);
  candidate.is_counted = is_wrong || (match.right > 0 && overlap > min_overlap);
  return candidate;
}

PlanesOfScene load(const DatasetEntry& entry, std::size_t dataset, double noise,
                   const FitArguments& arguments) {
  LoadedEntry loaded = load_entry(entry);
  loaded.scene.cloud = with_noise(std::move(loaded.scene.cloud), noise, dataset);
  const PipelineOptions options;
  const SceneProposals proposals = propose_objects(loaded.scene, options);
  const SegmentationResult chosen = choose_objects(proposals, options);
  const std::vector<PointIndices> truth =
      transfer_masks(loaded.scene.cloud, loaded.truth, proposals.cloud);
  PlanesOfScene scene;
  scene.dataset = dataset;
  std::size_t count = 0;
  for (const ObjectProposal& proposal : proposals.objects) {
    const bool is_chosen =
        std::any_of(chosen.objects.begin(), chosen.objects.end(),
                    [&](const auto& o) { return o.points == proposal.object.points; });
    if (!is_chosen && (proposal.object.score < min_object_score || count >= most_objects)) continue;
    ++count;
    SceneObject object = proposal.object;
    find_axes(proposals, options, object);
    const double overlap = best_overlap(truth, object.points);
    for (const MeasuredPlane& plane : measured_planes(proposals, options, object)) {
      scene.planes.push_back(judged(plane, loaded.truth, overlap, arguments));
      scene.planes.back().is_chosen = is_chosen;
    }
  }
  scene.truth = std::move(loaded.truth);
  return scene;
}

std::vector<PlanesOfScene> load_all(const FitArguments& arguments) {
  std::vector<PlanesOfScene> scenes;
  for (std::size_t d = 0; d < arguments.datasets.size(); ++d) {
    for (const DatasetEntry& entry : read_dataset(arguments.datasets[d]).entries) {
      for (const double noise : arguments.noise) scenes.push_back(load(entry, d, noise, arguments));
      fmt::print(stderr, "\r{} scenes", scenes.size());
    }
  }
  fmt::print(stderr, "\n");
  return scenes;
}

std::vector<Sample> samples_of(const std::vector<PlanesOfScene>& scenes, std::size_t left_out) {
  std::vector<Sample> samples;
  for (const PlanesOfScene& scene : scenes) {
    if (scene.dataset == left_out) continue;
    for (const CandidatePlane& candidate : scene.planes) {
      if (candidate.is_counted) samples.push_back(candidate.sample);
    }
  }
  return samples;
}

/// Every dataset with trees that were fitted to the others.
void cross_validate(const std::vector<PlanesOfScene>& scenes, const FitArguments& arguments) {
  std::vector<BoostedTrees> models;
  for (std::size_t d = 0; d < arguments.datasets.size(); ++d)
    models.push_back(fit_trees(samples_of(scenes, d), arguments.boosting));
  fmt::print("each dataset judged by the others:\nmin probability      P      R      F\n");
  SymmetryTolerance tolerance;
  tolerance.distance = 0.1;
  for (int k = 4; k <= 14; ++k) {
    Score score;
    for (const PlanesOfScene& scene : scenes) {
      std::vector<ReflectionPlane> found;
      for (const CandidatePlane& candidate : scene.planes) {
        if (candidate.is_chosen &&
            models[scene.dataset].probability(candidate.sample.features) > 0.05 * k)
          found.push_back(candidate.plane);
      }
      score += match_planes(scene.truth, found, tolerance).score();
    }
    fmt::print("{:15.2f}  {:.3f}  {:.3f}  {:.3f}\n", 0.05 * k, score.precision(), score.recall(),
               score.f_measure());
  }
}

void run(const FitArguments& arguments) {
  const std::vector<PlanesOfScene> scenes = load_all(arguments);
  const std::vector<Sample> samples = samples_of(scenes, arguments.datasets.size());
  fmt::print("{} planes, {} of them right\n", samples.size(),
             std::count_if(samples.begin(), samples.end(),
                           [](const Sample& sample) { return sample.target > 0.5; }));
  if (arguments.datasets.size() > 1) cross_validate(scenes, arguments);
  const BoostedTrees model = fit_trees(samples, arguments.boosting);
  print_use<PlaneMeasures>(model);
  if (!arguments.output.empty()) {
    write_file_atomically(arguments.output,
                          as_table(model, "symscene_fit_plane_score", "plane_score"));
  }
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::FitArguments arguments;
  arguments.boosting.depth = 4;
  arguments.boosting.rounds = 80;
  CLI::App app{
      "Fits the probability that a plane is a mirror of an object to datasets with truth."};
  symscene::bench::add_fit_options(app, arguments);
  return symscene::bench::run_fit(app, argc, argv, "symscene_fit_plane_score",
                                  [&] { symscene::bench::run(arguments); });
}
