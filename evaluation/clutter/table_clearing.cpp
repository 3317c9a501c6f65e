#include "symscene/clutter/table_clearing.hpp"

#include <algorithm>

#include "clutter/found_mesh.hpp"
#include "clutter/grasp_aim.hpp"
#include "core/random.hpp"
#include "symscene/clutter/graspability.hpp"
#include "symscene/core/error.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

std::vector<TriangleMesh> surfaces_of(const Tabletop& tabletop) {
  std::vector<TriangleMesh> surfaces;
  for (const PlacedObject& placed : tabletop.objects) surfaces.push_back(world_mesh(placed));
  return surfaces;
}

/// A table, the hand's way with it and what comes of it.
class Clearing {
 public:
  Clearing(TableWorld& world, const TableClearingOptions& options, Random& random,
           TableClearing& result)
      : world_(world), options_(options), random_(random), result_(result) {
    physical_.friction = options.physics.finger_friction;
    const Tabletop tabletop = world.tabletop();
    const std::vector<TriangleMesh> surfaces = surfaces_of(tabletop);
    const std::vector<std::size_t> present = world.present();
    graspable_.resize(present.empty() ? 0 : present.back() + 1);
    for (std::size_t k = 0; k < present.size(); ++k)
      graspable_[present[k]] = graspability(surfaces[k], tabletop.plane(), physical_);
    result.placed = static_cast<int>(present.size());
  }

  void run(const TableObserver& observer) {
    for (int failures = 0; !world_.present().empty();) {
      look_and_try();
      const TableAttempt& attempt = result_.attempts.back();
      if (observer) observer(attempt);
      if (!attempt.tried) return end(RoundEnd::no_grasp);
      if (attempt.outcome.end == GraspEnd::diverged) return end(RoundEnd::diverged);
      failures = attempt.succeeded() ? 0 : failures + 1;
      if (failures == options_.max_failures) return end(RoundEnd::failures);
      result_.stopped = attempt.number == options_.max_looks && !world_.present().empty();
      if (result_.stopped) return;
    }
  }

 private:
  void end(RoundEnd end) { result_.end = end; }

  void look_and_try() {
    const Tabletop tabletop = world_.tabletop();
    SweepOptions sweep = options_.sweep;
    sweep.tabletop.seed = random_.seed();  // of noise and shake
    const TableLook look = look_at_table(tabletop, sweep, options_.look);
    const TableProposals proposals =
        propose_table_grasps(options_.method, look, gripper_, options_.pipeline, options_.grasping);
    const std::vector<TriangleMesh> surfaces = surfaces_of(tabletop);
    const TrueSurface truth(surfaces);
    if (result_.attempts.empty()) note_first_look(proposals, truth);
    result_.attempts.push_back(described(look, proposals));
    if (!proposals.grasps.empty())
      try_grasp(proposals.grasps.front(), truth, result_.attempts.back());
  }

  TableAttempt described(const TableLook& look, const TableProposals& proposals) const {
    TableAttempt attempt;
    attempt.number = static_cast<int>(result_.attempts.size()) + 1;
    attempt.present = world_.present().size();
    attempt.found = proposals.objects.size();
    attempt.frames = look.frames;
    attempt.fused = look.fused;
    attempt.drift = look.trajectory.absolute;
    attempt.reconstruction_seconds = look.seconds;
    attempt.segmentation_seconds = proposals.segmentation_seconds;
    attempt.grasping_seconds = proposals.grasping_seconds;
    return attempt;
  }

  void note_first_look(const TableProposals& proposals, const TrueSurface& truth) {
    const std::vector<std::size_t> present = world_.present();
    std::vector<FirstLookObject> objects;
    for (const std::size_t i : present)
      objects.push_back({world_.model(i).name, graspable_[i].at_all, graspable_[i].as_it_lies,
                         false, 0, "not found as an object of its own"});
    std::vector<Index> meshes;  // per found object
    for (const FoundObject& found : proposals.objects) {
      const Index mesh = found_mesh(found.points, truth, present.size());
      meshes.push_back(mesh);
      if (mesh == TrueSurface::Nearest::nothing) continue;
      FirstLookObject& object = objects[mesh];
      // Found objects come in descending order of confidence or size: the first one says why.
      if (!object.found) object.reason = found.reason;
      object.found = true;
      object.grasps += found.grasps;
    }
    for (FirstLookObject& object : objects) {
      if (object.grasps > 0) object.reason.clear();
    }
    if (options_.try_each_object) try_each(proposals.grasps, meshes, objects);
    result_.first_look = std::move(objects);
  }

  /// `meshes` has the number of the true object of each found object.
  void try_each(const std::vector<Grasp>& grasps, const std::vector<Index>& meshes,
                std::vector<FirstLookObject>& objects) {
    for (const Grasp& grasp : grasps) {
      const Index mesh = meshes[static_cast<std::size_t>(grasp.object)];
      if (mesh == TrueSurface::Nearest::nothing || objects[mesh].end) continue;
      objects[mesh].end = world_.rehearse(grasp.T_world_tool, options_.execution).end;
    }
  }

  void try_grasp(const Grasp& grasp, const TrueSurface& truth, TableAttempt& attempt) {
    const std::vector<std::size_t> present = world_.present();
    const TrueSurface::Nearest nearest = aim_of(grasp, truth);
    const std::size_t aimed = present[nearest.mesh];
    attempt.tried = true;
    attempt.grasp = grasp;
    attempt.aimed = world_.model(aimed).name;
    attempt.aimed_distance = nearest.distance;
    attempt.penetration = world_.penetration(grasp.T_world_tool, aimed);
    execute(grasp, attempt);
    const GraspOutcome& outcome = attempt.outcome;
    const bool is_other = outcome.body && *outcome.body != aimed;
    attempt.removed_other = is_other && attempt.succeeded();
    attempt.touched_other = is_other && outcome.contact == ApproachContact::body;
    count_removed(attempt, present.size());
  }

  void execute(const Grasp& grasp, TableAttempt& attempt) {
    try {
      attempt.outcome = world_.execute(grasp.T_world_tool, options_.execution);
    } catch (const PhysicsDiverged&) {
      attempt.outcome.end = GraspEnd::diverged;
    }
  }

  void count_removed(const TableAttempt& attempt, std::size_t before) {
    const auto gone = static_cast<int>(before - world_.present().size());
    result_.fallen += gone - (attempt.succeeded() ? 1 : 0);
    if (!attempt.succeeded()) return;
    ++result_.removed;
    if (graspable_[*attempt.outcome.body].at_all) ++result_.removed_graspable;
  }

  TableWorld& world_;
  const TableClearingOptions& options_;
  Random& random_;
  TableClearing& result_;
  const Gripper gripper_ = panda_hand();
  Gripper physical_ = panda_hand();  ///< with the friction of the physics
  std::vector<Graspability> graspable_;
};

}  // namespace

SweepOptions TableClearingOptions::default_sweep() {
  SweepOptions sweep;
  sweep.drop.spread = 0.3;
  sweep.drop.area = 0.5;
  sweep.tabletop.table = {1.2, 1.2, 0.75, 0.0};
  sweep.camera.frames = 60;
  sweep.camera.arc = radians(60.0);
  return sweep;
}

void TableClearingOptions::validate() const {
  require_option(min_objects >= 1, "min_objects", "at least 1", min_objects);
  require_option(max_objects >= min_objects, "max_objects", "at least min_objects", max_objects);
  require_option(max_failures >= 1, "max_failures", "at least 1", max_failures);
  require_option(max_looks >= 0, "max_looks", "at least 0", max_looks);
  require_sensed_method(method);
  sweep.validate();
  look.validate();
  pipeline.validate();
  grasping.validate();
  execution.validate();
  physics.validate();
}

TableClearing clear_table(std::span<const ObjectModel> models, const TableClearingOptions& options,
                          int table, const TableObserver& observer) {
  options.validate();
  TableClearing result;
  result.table = table;
  Random random(options.seed, static_cast<std::uint64_t>(table));
  TabletopOptions tabletop_options = options.sweep.tabletop;
  tabletop_options.objects =
      options.min_objects + table % (options.max_objects - options.min_objects + 1);
  tabletop_options.seed = random.seed();
  try {
    const Tabletop tabletop = drop_tabletop(models, tabletop_options, options.sweep.drop);
    result.warnings = tabletop.warnings;
    TableWorld world(tabletop, options.sweep.drop, options.physics);
    Clearing(world, options, random, result).run(observer);
    for (const std::size_t i : world.present()) result.left.push_back(world.model(i).name);
  } catch (const PhysicsDiverged&) {
    result.end = RoundEnd::diverged;
  }
  return result;
}

}  // namespace symscene
