#include "symscene/exploration/exploration.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "benchmark_frame.hpp"
#include "clutter/grasp_aim.hpp"
#include "core/random.hpp"
#include "exploration_loop.hpp"
#include "resting_objects.hpp"
#include "symscene/core/error.hpp"
#include "symscene/evaluation/symmetry_metrics.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/grasping/planner.hpp"

namespace symscene {
namespace {

/// The numbers that are drawn for a scene before its objects.
struct SceneSeeds {
  Random random;
  std::uint64_t objects, noise;

  SceneSeeds(const ExplorationOptions& options, int scene)
      : random(options.seed, static_cast<std::uint64_t>(scene)),
        objects(random.seed()),
        noise(random.seed()) {}
};

/// A scene that all policies explore.
class ExploredObjects {
 public:
  ExploredObjects(RestingObjects objects, const ExplorationOptions& options, SceneSeeds& seeds)
      : options_(options),
        objects_(std::move(objects)),
        noise_seed_(seeds.noise),
        world_(objects_.surfaces,
               exploration_candidates(options.radius,
                                      seeds.random.uniform(0.0, 2.0 * std::numbers::pi)),
               options.noise, noise_seed_) {}

  Exploration explore_by(ExplorationPolicy policy) {
    ViewChooser chooser(policy, world_.candidates(), first_view, options_.next_view,
                        Random(noise_seed_, world_.candidates().size()));
    int views = 0;
    return explore(world_, chooser, options_.sensing,
                   {.views = options_.views,
                    .observer = [&](const ExplorationLook& look, ExplorationStep& step) {
                      count_symmetries(look.result, step);
                      if (++views == 1 && !least_visible_) find_least_visible(look.scene);
                      if (views == options_.grasp_after)
                        step.grasped = grasp_least_visible(look.scene, look.result);
                    }});
  }

 private:
  void count_symmetries(const SegmentationResult& result, ExplorationStep& step) const {
    const SymmetryTolerance near;
    step.axes = match_axes(objects_.truth, all_axes(result.objects), near).detections();
    step.planes = match_planes(objects_.truth, all_planes(result.objects), near).detections();
  }

  /// That of which the first view, which all policies share, shows least.
  void find_least_visible(const Scene& scene) {
    const std::vector<double> shares = world_.truth().shares(scene.cloud.positions);
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
      return aim_of(grasp, world_.truth().surface()).mesh == *least_visible_;
    });
    if (best == plan.grasps.end()) return false;
    const GraspOutcome outcome = objects_.rehearse(best->T_world_tool, options_.execution);
    return outcome.end == GraspEnd::success && outcome.body == objects_.bodies[*least_visible_];
  }

  const ExplorationOptions& options_;
  RestingObjects objects_;
  std::uint64_t noise_seed_;
  ExplorationWorld world_;
  std::optional<std::size_t> least_visible_;  ///< of the objects that are present
};

/// The same objects by each of the policies.
std::vector<Exploration> explore_by_all(ExploredObjects objects, const char* kind, int scene,
                                        std::span<const ExplorationPolicy> policies) {
  std::vector<Exploration> explorations;
  for (const ExplorationPolicy policy : policies) {
    explorations.push_back(objects.explore_by(policy));
    explorations.back().kind = kind;
    explorations.back().scene = scene;
  }
  return explorations;
}

Tabletop scanned_table(std::span<const ObjectModel> models, const ExplorationOptions& options,
                       std::uint64_t seed) {
  TabletopOptions arrangement;
  arrangement.objects = options.objects;
  arrangement.seed = seed;
  return in_benchmark_frame(drop_tabletop(models, arrangement, options.drop));
}

}  // namespace

const char* to_string(ExplorationEnd end) {
  switch (end) {
    case ExplorationEnd::views:
      return "views";
    case ExplorationEnd::enough:
      return "enough";
    case ExplorationEnd::no_view:
      return "no-view";
  }
  return "";
}

DropOptions ExplorationOptions::default_drop() {
  DropOptions drop;
  drop.spread = 0.12;
  return drop;
}

void ExplorationOptions::validate() const {
  const auto check = [](bool is_valid, const char* name, const char* expected) {
    if (!is_valid) throw InputError(name, expected, "another value");
  };
  check(objects >= 1, "objects", "at least 1");
  check(views >= 1, "views", "at least 1");
  check(radius > 0.0, "radius", "a positive number");
  drop.validate();
  next_view.validate();
  noise.validate();
  execution.validate();
}

std::vector<Exploration> explore_clutter(std::span<const ClutterObject> objects,
                                         std::span<const ExplorationPolicy> policies,
                                         const ExplorationOptions& options, int scene) {
  options.validate();
  SceneSeeds seeds(options, scene);
  ClutterWorld world(objects, options.kind, options.objects, seeds.objects, options.physics);
  return explore_by_all({resting_objects(world), options, seeds}, to_string(options.kind), scene,
                        policies);
}

std::vector<Exploration> explore_scanned_table(std::span<const ObjectModel> models,
                                               std::span<const ExplorationPolicy> policies,
                                               const ExplorationOptions& options, int scene) {
  options.validate();
  SceneSeeds seeds(options, scene);
  TableWorld world(scanned_table(models, options, seeds.objects), options.drop, options.physics);
  return explore_by_all({resting_objects(world), options, seeds}, scanned_table_kind, scene,
                        policies);
}

}  // namespace symscene
