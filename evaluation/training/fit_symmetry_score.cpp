// Fits the probability that a plane or an axis is a symmetry of an object to datasets with truth:
// see README.md.
#include "core/parallel.hpp"
#include "io/atomic_file.hpp"
#include "symmetry/mask_symmetry.hpp"
#include "symscene/evaluation/mask_metrics.hpp"
#include "symscene/evaluation/symmetry_metrics.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "tree_fitting.hpp"

namespace symscene::bench {
namespace {

constexpr double min_object_score = 0.25;  // of a proposal whose symmetries are learned from
constexpr std::size_t most_objects = 40;   // a scene
constexpr double min_overlap = 0.4;        // of a proposal and the object whose symmetry is right

/// What differs between the two kinds.
struct Axes {
  using Symmetry = RotationAxis;
  using Measures = AxisFeatures;
  static constexpr const char* table = "axis_score";
  static SymmetryMatch match(const SceneTruth& truth, std::span<const RotationAxis> found,
                             const SymmetryTolerance& tolerance) {
    return match_axes(truth, found, tolerance);
  }
  static std::vector<std::pair<RotationAxis, AxisFeatures>> measured(
      const SceneProposals& proposals, const PipelineOptions& options, const SceneObject& object) {
    const std::optional<MeasuredAxis> axis =
        measured_axis(proposals.observed(), options.whole_object_options(), object);
    if (!axis) return {};
    return {{axis->axis, axis->features}};
  }
};

struct Planes {
  using Symmetry = ReflectionPlane;
  using Measures = PlaneFeatures;
  static constexpr const char* table = "plane_score";
  static SymmetryMatch match(const SceneTruth& truth, std::span<const ReflectionPlane> found,
                             const SymmetryTolerance& tolerance) {
    return match_planes(truth, found, tolerance);
  }
  static std::vector<std::pair<ReflectionPlane, PlaneFeatures>> measured(
      const SceneProposals& proposals, const PipelineOptions& options, const SceneObject& object) {
    std::vector<std::pair<ReflectionPlane, PlaneFeatures>> planes;
    for (const MeasuredPlane& plane :
         measure_symmetries(proposals.observed(), options.whole_object_options(), object).planes)
      planes.emplace_back(plane.plane, plane.features);
    return planes;
  }
};

template <class Kind>
struct Candidate {
  typename Kind::Symmetry symmetry;
  Sample sample;
  bool is_counted = true;  ///< right or wrong, not neither
  bool is_chosen = true;   ///< of an object that is chosen
};

template <class Kind>
struct CandidatesOfScene {
  std::size_t dataset = 0;
  SceneTruth truth;
  std::vector<Candidate<Kind>> candidates;
};

/// The true object that a proposal overlaps most, by itself.
struct Owner {
  SceneTruth truth;
  double overlap = 0.0;
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

/// Of the object that is meant: right within 3 cm, wrong beyond 10 cm.
template <class Kind>
Candidate<Kind> judged(const typename Kind::Symmetry& symmetry,
                       const typename Kind::Measures& features, const Owner& owner,
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
  candidate.is_counted = is_wrong || (match.right > 0 && owner.overlap > min_overlap);
  return candidate;
}

template <class Kind>
CandidatesOfScene<Kind> candidates_of(const FitScene& given, const FitArguments& arguments) {
  LoadedEntry loaded = load(given);
  const PipelineOptions options;
  const SceneProposals proposals = propose_objects(loaded.scene, options);
  std::vector<Rejection> rejected;
  const std::vector<SceneObject> chosen = probable_objects(proposals, options.selection, rejected);
  const std::vector<PointIndices> truth =
      transfer_masks(loaded.scene.cloud, loaded.truth, proposals.cloud);
  CandidatesOfScene<Kind> scene;
  scene.dataset = given.dataset;
  std::size_t count = 0;
  for (const ObjectProposal& proposal : proposals.objects) {
    const bool is_chosen = std::any_of(chosen.begin(), chosen.end(), [&](const auto& object) {
      return object.points == proposal.object.points;
    });
    if (!is_chosen && (proposal.object.score < min_object_score || count >= most_objects)) continue;
    ++count;
    const Owner owner = owner_of(loaded.truth, truth, proposal.object.points);
    for (const auto& [symmetry, features] : Kind::measured(proposals, options, proposal.object)) {
      scene.candidates.push_back(judged<Kind>(symmetry, features, owner, arguments));
      scene.candidates.back().is_chosen = is_chosen;
    }
  }
  scene.truth = std::move(loaded.truth);
  return scene;
}

template <class Kind>
std::vector<CandidatesOfScene<Kind>> load_all(const FitArguments& arguments) {
  const std::vector<FitScene> given = fit_scenes(arguments);
  std::vector<CandidatesOfScene<Kind>> scenes(given.size());
  parallel_for_each(given.size(),
                    [&](std::size_t k) { scenes[k] = candidates_of<Kind>(given[k], arguments); });
  return scenes;
}

template <class Kind>
std::vector<Sample> samples_of(const std::vector<CandidatesOfScene<Kind>>& scenes,
                               std::size_t left_out) {
  std::vector<Sample> samples;
  for (const CandidatesOfScene<Kind>& scene : scenes) {
    if (scene.dataset == left_out) continue;
    for (const Candidate<Kind>& candidate : scene.candidates) {
      if (candidate.is_counted) samples.push_back(candidate.sample);
    }
  }
  return samples;
}

/// Every dataset with trees that were fitted to the others.
template <class Kind>
void cross_validate(const std::vector<CandidatesOfScene<Kind>>& scenes,
                    const FitArguments& arguments) {
  std::vector<BoostedTrees> models(arguments.datasets.size());
  parallel_for_each(models.size(), [&](std::size_t d) {
    models[d] = fit_trees(samples_of(scenes, d), arguments.boosting);
  });
  fmt::print("each dataset judged by the others:\nmin probability      P      R      F\n");
  SymmetryTolerance tolerance;
  tolerance.distance = 0.1;
  for (int k = 0; k <= 14; ++k) {
    Score score;
    for (const CandidatesOfScene<Kind>& scene : scenes) {
      std::vector<typename Kind::Symmetry> found;
      for (const Candidate<Kind>& candidate : scene.candidates) {
        if (candidate.is_chosen &&
            models[scene.dataset].probability(candidate.sample.features) > 0.05 * k)
          found.push_back(candidate.symmetry);
      }
      score += Kind::match(scene.truth, found, tolerance).score();
    }
    fmt::print("{:15.2f}  {:.3f}  {:.3f}  {:.3f}\n", 0.05 * k, score.precision(), score.recall(),
               score.f_measure());
  }
}

template <class Kind>
void run(const FitArguments& arguments) {
  const std::vector<CandidatesOfScene<Kind>> scenes = load_all<Kind>(arguments);
  const std::vector<Sample> samples = samples_of(scenes, arguments.datasets.size());
  fmt::print("{} candidates, {} of them right\n", samples.size(),
             std::count_if(samples.begin(), samples.end(),
                           [](const Sample& sample) { return sample.target > 0.5; }));
  if (arguments.datasets.size() > 1) cross_validate(scenes, arguments);
  const BoostedTrees model = fit_trees(samples, arguments.boosting);
  print_use<typename Kind::Measures>(model);
  if (!arguments.output.empty()) {
    write_file_atomically(arguments.output,
                          as_table(model, "symscene_fit_symmetry_score", Kind::table));
  }
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
      "truth."};
  std::string kind;
  app.add_option("kind", kind, "axes or planes")
      ->required()
      ->check(CLI::IsMember({"axes", "planes"}));
  add_fit_options(app, arguments);
  return run_fit(app, argc, argv, "symscene_fit_symmetry_score",
                 [&] { kind == "axes" ? run<Axes>(arguments) : run<Planes>(arguments); });
}
