#include "symscene/clutter/clutter_rounds.hpp"

#include <algorithm>

#include "clutter/grasp_aim.hpp"
#include "core/random.hpp"
#include "symscene/core/error.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

/// The object that a grasp aims at.
struct Aim {
  std::size_t item = 0;
  double distance = 0.0;  ///< [m]
  double occlusion = 0.0;
};

/// Which objects grasps aim at while no object moves.
class Aims {
 public:
  Aims(const ClutterWorld& world, int views)
      : items_(world.present()),
        occlusion_(clutter_occlusion(world, views)),
        surface_(world.surfaces()) {}

  const std::vector<std::size_t>& items() const { return items_; }
  const std::vector<double>& occlusion() const { return occlusion_; }

  Aim of(const Grasp& grasp) const {
    const TrueSurface::Nearest nearest = aim_of(grasp, surface_);
    return {items_[nearest.mesh], nearest.distance, occlusion_[nearest.mesh]};
  }

 private:
  std::vector<std::size_t> items_;
  std::vector<double> occlusion_;
  TrueSurface surface_;
};

/// How a grasp is tried.
using WayToTry = GraspOutcome (*)(ClutterWorld&, const Eigen::Isometry3d&,
                                  const GraspExecutionOptions&);

/// A grasp in which the physics diverges has failed.
GraspOutcome executed(ClutterWorld& world, const Eigen::Isometry3d& T_world_tool,
                      const GraspExecutionOptions& options) {
  try {
    return world.execute(T_world_tool, options);
  } catch (const PhysicsDiverged&) {
    GraspOutcome outcome;
    outcome.end = GraspEnd::diverged;
    return outcome;
  }
}

GraspOutcome rehearsed(ClutterWorld& world, const Eigen::Isometry3d& T_world_tool,
                       const GraspExecutionOptions& options) {
  return world.rehearse(T_world_tool, options);
}

ClutterAttempt attempt_grasp(ClutterWorld& world, const Aims& aims, const GraspProposals& proposals,
                             std::size_t chosen, WayToTry way,
                             const GraspExecutionOptions& execution) {
  ClutterAttempt attempt;
  attempt.grasp = proposals.grasps[chosen];
  const Aim aim = aims.of(attempt.grasp);
  attempt.aimed = world.object(aim.item).name;
  attempt.aimed_distance = aim.distance;
  attempt.occlusion = aim.occlusion;
  attempt.seen = proposals.objects;
  attempt.present = world.present().size();
  attempt.seconds = proposals.seconds;
  attempt.grasping_seconds = proposals.grasping_seconds;
  attempt.penetration = world.penetration(attempt.grasp.T_world_tool, aim.item);
  attempt.outcome = way(world, attempt.grasp.T_world_tool, execution);
  const GraspOutcome& outcome = attempt.outcome;
  const bool is_other = outcome.body && *outcome.body != aim.item;
  attempt.removed_other = is_other && outcome.end == GraspEnd::success;
  attempt.touched_other = is_other && outcome.contact == ApproachContact::body;
  return attempt;
}

void rehearse(ClutterWorld& world, const Aims& aims, const GraspProposals& proposals,
              const ClutterRoundOptions& options, std::uint64_t seed,
              std::vector<ClutterAttempt>& tried) {
  Random random(seed);
  const auto grasps = static_cast<std::uint32_t>(proposals.grasps.size());
  for (int k = 0; k < options.rehearsals; ++k) {
    tried.push_back(
        attempt_grasp(world, aims, proposals, random.below(grasps), rehearsed, options.execution));
  }
}

/// Tries and undoes the best grasp of each object.
void rehearse_best(ClutterWorld& world, const Aims& aims, const GraspProposals& proposals,
                   const GraspExecutionOptions& execution, ClutterRound& result) {
  const std::vector<Grasp>& grasps = proposals.grasps;
  for (std::size_t k = 0; k < aims.items().size(); ++k) {
    ObjectTrial trial{aims.occlusion()[k]};
    const auto best = std::find_if(grasps.begin(), grasps.end(), [&](const Grasp& grasp) {
      return aims.of(grasp).item == aims.items()[k];
    });
    if (best != grasps.end()) {
      result.rehearsals.push_back(attempt_grasp(world, aims, proposals,
                                                static_cast<std::size_t>(best - grasps.begin()),
                                                rehearsed, execution));
      trial.succeeded = result.rehearsals.back().outcome.end == GraspEnd::success;
    }
    result.trials.push_back(trial);
  }
}

/// One proposal and its execution; returns whether there was a grasp.
bool try_once(ClutterWorld& world, const ClutterRoundOptions& options, int round, Random& random,
              const ClutterObserver& observer, ClutterRound& result) {
  const std::uint64_t noise_seed = random.seed(), method_seed = random.seed();
  const std::vector<ClutterView> views =
      clutter_views(world, options.views, options.noise, noise_seed);
  const GraspProposals proposals =
      propose_grasps(options.method, world, views, options.planning, method_seed);
  if (observer.before) observer.before(world, views, proposals);
  const Aims aims(world, options.views);
  const std::size_t first_rehearsal = result.rehearsals.size();
  if (options.rehearse_best) rehearse_best(world, aims, proposals, options.execution, result);
  if (proposals.grasps.empty()) {
    result.reasons = proposals.reasons;
    result.outside = proposals.outside;
    return false;
  }
  rehearse(world, aims, proposals, options, method_seed, result.rehearsals);
  result.attempts.push_back(attempt_grasp(world, aims, proposals, 0, executed, options.execution));
  const auto number = static_cast<int>(result.attempts.size());
  const auto name = [&](ClutterAttempt& attempt) {
    attempt.round = round;
    attempt.number = number;
  };
  name(result.attempts.back());
  std::for_each(result.rehearsals.begin() + static_cast<std::ptrdiff_t>(first_rehearsal),
                result.rehearsals.end(), name);
  if (observer.after) observer.after(result.attempts.back());
  return true;
}

void note_placed(const ClutterWorld& world, int views, ClutterRound& result) {
  const std::vector<std::size_t> items = world.present();
  const std::vector<double> occlusion = clutter_occlusion(world, views);
  result.placed = result.left = static_cast<int>(items.size());
  for (std::size_t k = 0; k < items.size(); ++k)
    result.placed_objects.push_back({items[k], occlusion[k], false});
}

void note_removed(const GraspOutcome& outcome, ClutterRound& result) {
  if (outcome.end != GraspEnd::success) return;
  ++result.removed;
  for (PlacedItem& object : result.placed_objects) {
    if (outcome.body == object.item) object.removed = true;
  }
}

void play(ClutterWorld& world, const ClutterRoundOptions& options, int round, Random& random,
          const ClutterObserver& observer, ClutterRound& result) {
  note_placed(world, options.views, result);
  for (int failures = 0; result.left > 0;) {
    if (!try_once(world, options, round, random, observer, result)) {
      result.end = RoundEnd::no_grasp;
      return;
    }
    const GraspEnd end = result.attempts.back().outcome.end;
    note_removed(result.attempts.back().outcome, result);
    result.left = static_cast<int>(world.present().size());
    if (end == GraspEnd::diverged) {
      result.end = RoundEnd::diverged;
      return;
    }
    failures = end == GraspEnd::success ? 0 : failures + 1;
    if (failures == options.max_failures) {
      result.end = RoundEnd::failures;
      return;
    }
  }
}

}  // namespace

void ClutterRoundOptions::validate() const {
  require_option(objects >= 1, "objects", "at least 1", objects);
  require_option(views >= 1, "views", "at least 1", views);
  require_option(rehearsals >= 0, "rehearsals", "at least 0", rehearsals);
  require_option(max_failures >= 1, "max_failures", "at least 1", max_failures);
  noise.validate();
  execution.validate();
  physics.validate();
}

const char* to_string(RoundEnd end) {
  switch (end) {
    case RoundEnd::cleared:
      return "cleared";
    case RoundEnd::no_grasp:
      return "no grasp proposed";
    case RoundEnd::failures:
      return "failures in a row";
    case RoundEnd::diverged:
      break;
  }
  return "the physics diverged";
}

ClutterRound run_clutter_round(std::span<const ClutterObject> objects,
                               const ClutterRoundOptions& options, int round,
                               const ClutterObserver& observer) {
  options.validate();
  ClutterRound result;
  try {
    Random random(options.seed, static_cast<std::uint64_t>(round));
    ClutterWorld world(objects, options.kind, options.objects, random.seed(), options.physics);
    play(world, options, round, random, observer, result);
    for (const std::size_t item : world.present())
      result.left_objects.push_back(world.object(item).name);
  } catch (const PhysicsDiverged&) {
    result.end = RoundEnd::diverged;
  }
  return result;
}

}  // namespace symscene
