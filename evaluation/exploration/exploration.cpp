#include "symscene/exploration/exploration.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include <fmt/format.h>

#include "clutter/grasp_aim.hpp"
#include "clutter/sensed_scene.hpp"
#include "symscene/core/error.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "symscene/view_planning/view_candidates.hpp"
#include "view_chooser.hpp"

namespace symscene {
namespace {

constexpr std::array policies{
    ExplorationPolicy::symmetry,         ExplorationPolicy::unknown_voxels,
    ExplorationPolicy::rear_side_voxels, ExplorationPolicy::fixed_arc,
    ExplorationPolicy::random,           ExplorationPolicy::oracle};
constexpr std::array policy_names{"symmetry",  "unknown-voxels", "rear-side-voxels",
                                  "fixed-arc", "random",         "oracle"};
const Eigen::Vector3d target(0.5 * clutter::size, 0.5 * clutter::size, 0.10);

/// The first view is that of the outermost ring which comes first.
constexpr std::size_t first_view = default_view_rings[0].views + default_view_rings[1].views;

/// A scene that all policies explore.
class ExplorationWorld {
 public:
  ExplorationWorld(std::span<const ClutterObject> objects, const ExplorationOptions& options,
                   int scene)
      : options_(options),
        random_(options.seed, static_cast<std::uint64_t>(scene)),
        world_(objects, options.kind, options.objects, random_.seed(), options.physics),
        noise_seed_(random_.seed()),
        candidates_(views_on_sphere(target, Eigen::Vector3d::UnitZ(), options.radius,
                                    default_view_rings,
                                    random_.uniform(0.0, 2.0 * std::numbers::pi))),
        truth_(world_) {}

  Exploration explore(ExplorationPolicy policy) {
    Exploration exploration;
    exploration.policy = policy;
    ViewChooser chooser(policy, candidates_, first_view, options_.next_view,
                        Random(noise_seed_, candidates_.size()));
    std::vector<ClutterView> views;
    ExplorationStep step;
    step.view = first_view;
    for (int k = 1; k <= options_.views; ++k) {
      views.push_back(clutter_view(world_, candidates_[step.view], options_.noise,
                                   Random(noise_seed_, step.view)));
      const Scene scene = sensed_scene(views, options_.sensing);
      SegmentationResult result;
      if (!scene.cloud.empty()) result = segment_scene(scene, options_.sensing.pipeline);
      if (k == 1 && !least_visible_) find_least_visible(scene);
      measure(scene, result, k, step);
      exploration.steps.push_back(step);
      if (k == options_.views) break;
      StageTimer timer;
      const auto next = timer.time("choice", [&] { return chooser.next({scene, result, truth_}); });
      if (!next) break;
      step = {*next, 0.0, 0.0, {}, {}, timer.stages().front().seconds};
    }
    return exploration;
  }

 private:
  void measure(const Scene& scene, const SegmentationResult& result, int views,
               ExplorationStep& step) {
    step.observed = truth_.observed(scene);
    step.completed = truth_.completed(scene, result);
    step.masks = truth_.masks(result);
    if (views == options_.grasp_after) step.grasped = grasp_least_visible(scene, result);
  }

  /// That of which the first view, which all policies share, shows least.
  void find_least_visible(const Scene& scene) {
    const std::vector<double> shares = truth_.shares(scene.cloud.positions);
    if (shares.empty()) return;
    least_visible_ =
        static_cast<std::size_t>(std::min_element(shares.begin(), shares.end()) - shares.begin());
  }

  bool grasp_least_visible(const Scene& scene, const SegmentationResult& result) {
    if (!least_visible_ || result.objects.empty()) return false;
    const GraspOptions& grasping = options_.sensing.grasping;
    const GraspPlan plan =
        plan_grasps(grasp_scene(result, &scene, grasping), panda_hand(), grasping);
    const auto best = std::find_if(plan.grasps.begin(), plan.grasps.end(), [&](const Grasp& grasp) {
      return aim_of(grasp, truth_.surface()).mesh == *least_visible_;
    });
    if (best == plan.grasps.end()) return false;
    const GraspOutcome outcome = world_.rehearse(best->T_world_tool, options_.execution);
    return outcome.end == GraspEnd::success && outcome.body == world_.present()[*least_visible_];
  }

  const ExplorationOptions& options_;
  Random random_;
  ClutterWorld world_;
  std::uint64_t noise_seed_;
  std::vector<Eigen::Isometry3d> candidates_;
  TrueCoverage truth_;
  std::optional<std::size_t> least_visible_;  ///< of the items that are present
};

template <class Measure>
double mean_of(const std::vector<ExplorationStep>& steps, Measure&& measure) {
  double sum = 0.0;
  for (const ExplorationStep& step : steps) sum += measure(step);
  return steps.empty() ? 0.0 : sum / static_cast<double>(steps.size());
}

}  // namespace

const char* to_string(ExplorationPolicy policy) {
  return policy_names.at(static_cast<std::size_t>(policy));
}

ExplorationPolicy parse_exploration_policy(std::string_view name) {
  for (const ExplorationPolicy policy : policies) {
    if (name == to_string(policy)) return policy;
  }
  throw InputError("policy", fmt::format("{}", fmt::join(policy_names, ", ")),
                   fmt::format("\"{}\"", name));
}

std::span<const ExplorationPolicy> exploration_policies() { return policies; }

void ExplorationOptions::validate() const {
  const auto check = [](bool is_valid, const char* name, const char* expected) {
    if (!is_valid) throw InputError(name, expected, "another value");
  };
  check(objects >= 1, "objects", "at least 1");
  check(views >= 1, "views", "at least 1");
  check(radius > 0.0, "radius", "a positive number");
  next_view.validate();
  noise.validate();
  execution.validate();
}

double Exploration::mean_observed() const {
  return mean_of(steps, [](const ExplorationStep& step) { return step.observed; });
}

double Exploration::mean_completed() const {
  return mean_of(steps, [](const ExplorationStep& step) { return step.completed; });
}

std::vector<Exploration> explore_clutter(std::span<const ClutterObject> objects,
                                         std::span<const ExplorationPolicy> policies,
                                         const ExplorationOptions& options, int scene) {
  options.validate();
  ExplorationWorld world(objects, options, scene);
  std::vector<Exploration> explorations;
  for (const ExplorationPolicy policy : policies) {
    explorations.push_back(world.explore(policy));
    explorations.back().scene = scene;
  }
  return explorations;
}

}  // namespace symscene
