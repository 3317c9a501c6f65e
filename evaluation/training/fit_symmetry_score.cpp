// Fits the model axis or plane to datasets with ground truth (evaluation/training/README.md).
#include <fmt/format.h>

#include <algorithm>

#include "fitting.hpp"
#include "proposals/object_proposals.hpp"
#include "symmetry/object_symmetry.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/evaluation/symmetry_metrics.hpp"

namespace symscene::bench {
namespace {

constexpr double min_object_score = 0.25;  // of a proposal whose symmetries are samples
constexpr std::size_t max_objects = 40;    // per scene
constexpr double min_overlap = 0.4;        // IoU of a proposal and the object of a correct symmetry

/// The two kinds of symmetries.
struct Axes {
  using Symmetry = RotationAxis;
  using Features = AxisFeatures;
  static constexpr const char* model = "axis";
  static SymmetryMatch match(const SceneTruth& truth, std::span<const RotationAxis> found,
                             const SymmetryTolerance& tolerance) {
    return match_axes(truth, found, tolerance);
  }
  static std::vector<std::pair<RotationAxis, AxisFeatures>> candidates(
      const SceneProposals& proposals, const PipelineOptions& options,
      const SearchedObject& object) {
    const std::optional<AxisCandidate> axis =
        axis_candidate(proposals.observed(), object, options.symmetry_search_options());
    if (!axis) return {};
    return {{axis->axis, axis->features}};
  }
};

struct Planes {
  using Symmetry = ReflectionPlane;
  using Features = PlaneFeatures;
  static constexpr const char* model = "plane";
  static SymmetryMatch match(const SceneTruth& truth, std::span<const ReflectionPlane> found,
                             const SymmetryTolerance& tolerance) {
    return match_planes(truth, found, tolerance);
  }
  static std::vector<std::pair<ReflectionPlane, PlaneFeatures>> candidates(
      const SceneProposals& proposals, const PipelineOptions& options,
      const SearchedObject& object) {
    std::vector<std::pair<ReflectionPlane, PlaneFeatures>> planes;
    for (const PlaneCandidate& plane :
         symmetry_candidates(proposals.observed(), object, options.symmetry_search_options())
             .planes)
      planes.emplace_back(plane.plane, plane.features);
    return planes;
  }
};

template <class Kind>
struct Candidate {
  typename Kind::Symmetry symmetry;
  Sample sample;
  bool is_sample = true;  ///< correct or wrong, not in between
  bool is_chosen = true;  ///< of an object that is chosen
};

template <class Kind>
struct CandidatesOfScene {
  std::size_t dataset = 0;
  SceneTruth truth;
  std::vector<Candidate<Kind>> candidates;
};

/// The object of the ground truth that a proposal overlaps most.
struct Owner {
  SceneTruth truth;      ///< that object alone
  double overlap = 0.0;  ///< IoU
};

Owner owner_of(const SceneTruth& truth, const std::vector<PointIndices>& masks,
               const PointIndices& points) {
  Owner owner;
  for (std::size_t k = 0; k < masks.size(); ++k) {
    const double overlap = intersection_over_union(masks[k], points);
    if (overlap <= owner.overlap) continue;
    owner.overlap = overlap;
    owner.truth.objects = {truth.objects[k]};
  }
  return owner;
}

/// Correct within 3 cm of a symmetry of the owner, wrong beyond 10 cm.
template <class Kind>
Candidate<Kind> judged(const typename Kind::Symmetry& symmetry,
                       const typename Kind::Features& features, const Owner& owner,
                       const FitArguments& arguments) {
  SymmetryTolerance near, far;
  near.distance = 0.03;
  far.distance = 0.1;
  const typename Kind::Symmetry found[] = {symmetry};
  const SymmetryMatch match = Kind::match(owner.truth, found, near);
  const bool is_wrong = match.wrong > 0 && Kind::match(owner.truth, found, far).wrong > 0;
  Candidate<Kind> candidate;
  candidate.symmetry = symmetry;
  candidate.sample = sample_of(features, is_wrong ? 0.0 : 1.0, arguments.without);
  candidate.is_sample = is_wrong || (match.right > 0 && owner.overlap > min_overlap);
  return candidate;
}

template <class Kind>
CandidatesOfScene<Kind> candidates_of(const FitScene& given, const FitArguments& arguments) {
  LoadedEntry loaded = load(given);
  const PipelineOptions options = pipeline_options(arguments);
  const SceneProposals proposals = propose_objects(loaded.scene, options);
  std::vector<Rejection> rejected;
  const std::vector<std::size_t> chosen =
      probable_proposals(proposals, options.selection, rejected);
  const std::vector<PointIndices> truth =
      transfer_masks(loaded.scene.cloud, loaded.truth, proposals.cloud);
  CandidatesOfScene<Kind> scene;
  scene.dataset = given.dataset;
  std::size_t count = 0;
  for (std::size_t k = 0; k < proposals.objects.size(); ++k) {
    const SearchedObject object = searched_object(proposals, k, options.object_symmetry);
    const bool is_chosen = std::find(chosen.begin(), chosen.end(), k) != chosen.end();
    if (!is_chosen && (object.score < min_object_score || count >= max_objects)) continue;
    ++count;
    const Owner owner = owner_of(loaded.truth, truth, object.points);
    for (const auto& [symmetry, features] : Kind::candidates(proposals, options, object)) {
      scene.candidates.push_back(judged<Kind>(symmetry, features, owner, arguments));
      scene.candidates.back().is_chosen = is_chosen;
    }
  }
  scene.truth = std::move(loaded.truth);
  return scene;
}

template <class Kind>
std::vector<Sample> samples_of(const std::vector<CandidatesOfScene<Kind>>& scenes,
                               std::size_t left_out) {
  std::vector<Sample> samples;
  for (const CandidatesOfScene<Kind>& scene : scenes) {
    if (scene.dataset == left_out) continue;
    for (const Candidate<Kind>& candidate : scene.candidates) {
      if (candidate.is_sample) samples.push_back(candidate.sample);
    }
  }
  return samples;
}

template <class Kind>
TreeModel fit(std::vector<Sample> samples, const FitArguments& arguments) {
  return fit_model(
      training_set<typename Kind::Features>(Kind::model, arguments, std::move(samples)),
      arguments.boosting);
}

/// Scores each dataset with a model fitted to the others.
template <class Kind>
void cross_validate(const std::vector<CandidatesOfScene<Kind>>& scenes,
                    const FitArguments& arguments) {
  const auto models = fit_without_each<TreeModel>(arguments, [&](std::size_t left_out) {
    return fit<Kind>(samples_of(scenes, left_out), arguments);
  });
  fmt::print(
      "each dataset scored by a model of the others:\nmin probability      P      R      F\n");
  SymmetryTolerance tolerance;
  tolerance.distance = 0.1;
  for (int k = 0; k <= 14; ++k) {
    DetectionCounts counts;
    for (const CandidatesOfScene<Kind>& scene : scenes) {
      std::vector<typename Kind::Symmetry> found;
      for (const Candidate<Kind>& candidate : scene.candidates) {
        if (candidate.is_chosen &&
            models[scene.dataset]->probability(candidate.sample.features) > 0.05 * k)
          found.push_back(candidate.symmetry);
      }
      counts += Kind::match(scene.truth, found, tolerance).detections();
    }
    fmt::print("{:15.2f}  {:.3f}  {:.3f}  {:.3f}\n", 0.05 * k, counts.precision(), counts.recall(),
               counts.f_measure());
  }
}

template <class Kind>
void run(const FitArguments& arguments) {
  const auto scenes = extract_all<CandidatesOfScene<Kind>>(
      arguments, [&](const FitScene& scene) { return candidates_of<Kind>(scene, arguments); });
  std::vector<Sample> samples = samples_of(scenes, arguments.datasets.size());
  fmt::print("{} candidates, {} of them correct\n", samples.size(),
             std::count_if(samples.begin(), samples.end(),
                           [](const Sample& sample) { return sample.target > 0.5; }));
  if (arguments.datasets.size() > 1) cross_validate(scenes, arguments);
  const TreeModel model = fit<Kind>(std::move(samples), arguments);
  print_split_counts(model);
  write_model(arguments, model);
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  using namespace symscene::bench;
  FitArguments arguments;
  arguments.boosting.depth = 4;
  arguments.boosting.rounds = 80;
  CLI::App app{
      "Fits the probability that an axis or a plane is a symmetry of an object to datasets with "
      "ground truth."};
  std::string kind;
  app.add_option("kind", kind, "axes or planes")
      ->required()
      ->check(CLI::IsMember({"axes", "planes"}));
  add_fit_options(app, arguments);
  return run_fit(app, argc, argv, arguments,
                 [&] { kind == "axes" ? run<Axes>(arguments) : run<Planes>(arguments); });
}
