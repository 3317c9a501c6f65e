#include "symscene/picking/simulated_picks.hpp"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "look_taker.hpp"
#include "object_ledger.hpp"
#include "pick_choice.hpp"
#include "run_recorder.hpp"
#include "symscene/core/error.hpp"
#include "symscene/motion/arm_collision.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

std::vector<TriangleMesh> surfaces_of(const Tabletop& tabletop) {
  std::vector<TriangleMesh> surfaces;
  for (const PlacedObject& placed : tabletop.objects) surfaces.push_back(world_mesh(placed));
  return surfaces;
}

/// The gripper with the friction that its fingers have in the physics.
Gripper physical(Gripper gripper, const SimulatedPickOptions& options) {
  gripper.friction = options.physics.contacts.finger_friction;
  return gripper;
}

/// A bin that the arm reaches, else any beside the table.
PickBin bin_for(const Robot& robot, const RobotArm& arm, const Gripper& gripper,
                const TableOptions& table, const PickExecutionOptions& options,
                std::vector<std::string>& warnings) {
  if (const auto bin = reachable_bin(robot, arm, gripper, table, options)) return *bin;
  warnings.push_back("the arm reaches no place beside the table for a bin");
  return {{0.0, 0.5 * (table.width + options.bin_width) + PickBin::wall},
          options.bin_width,
          options.bin_height};
}

/// One call of simulate_picks().
class PickLoop {
 public:
  PickLoop(const PickTable& table, const Robot& robot, const Gripper& gripper,
           const SimulatedPickOptions& options, const PickObserver& observer)
      : table_(table),
        robot_(robot),
        gripper_(gripper),
        options_(options),
        observer_(observer),
        arm_(robot.grasping_arm()),
        solids_(robot, arm_, gripper),
        bin_(bin_for(robot, arm_, gripper, table.tabletop.table, options.execution, run_.warnings)),
        bin_mesh_(bin_.mesh()),
        recorder_(table, solids_, bin_mesh_, options.record_rate, observer),
        failed_(gripper.finger_width),
        ledger_(table, physical(gripper, options)) {}

  PickRun run() {
    try {
      cell_.emplace(table_, robot_, arm_, gripper_, bin_, options_,
                    [this](const ArmCell& cell) { recorder_.step(cell); });
      settle();
      if (can_start() && plan_camera()) clear();
    } catch (const PhysicsDiverged&) {
      end(PickRunEnd::diverged);
    }
    finish();
    return std::move(run_);
  }

 private:
  void stage(const std::string& name) const {
    if (observer_.on_stage) observer_.on_stage(name);
  }
  void end(PickRunEnd reason) { run_.end = reason; }
  void tell(const std::string& text, RecordedOutcome outcome = RecordedOutcome::note) {
    recorder_.add(cell_ ? cell_->time() : 0.0, text, outcome);
  }

  /// Whether no arm meets the robot itself or the table at home.
  bool can_start() {
    GraspScene scene;
    scene.table = Plane{};
    const MotionObstacles obstacles(scene);
    for (const RobotArm& arm : robot_.arms) {
      const Gripper* gripper = &arm == &arm_ ? &gripper_ : nullptr;
      const ArmCollision collision(robot_, arm, gripper, gripper_.max_opening, obstacles,
                                   robot_.home);
      const auto contact = collision.contact(arm_positions(arm.arm, robot_.home));
      if (!contact) continue;
      not_looked_ = "the arm cannot start: " + describe(*contact);
      tell(not_looked_, RecordedOutcome::failure);
      run_.warnings.clear();  // that no bin is reached follows from it
      end(PickRunEnd::no_start);
      return false;
    }
    return true;
  }

  /// Whether the camera sees the table.
  bool plan_camera() {
    stage("motion of the camera");
    camera_.emplace(robot_, solids_, gripper_, bin_, bin_mesh_, options_);
    if (camera_->is_flying())
      tell("the robot's description has no camera on an arm: a camera flies around the table");
    not_looked_ = timer_.time("motion of the camera", [&] { return camera_->plan(); });
    if (not_looked_.empty()) return true;
    tell(not_looked_, RecordedOutcome::failure);
    end(PickRunEnd::no_view);
    return false;
  }

  void clear() {
    for (int looks = 0, empty = 0; !cell_->present().empty(); ++looks) {
      if (looks == options_.max_looks) return end(PickRunEnd::looks);
      look();
      PickChoice choice = choose();
      empty = choice.planned ? 0 : empty + 1;
      if (choice.planned)
        attempt(*choice.planned);
      else if (empty == options_.empty_looks)
        return end(belief_.scene.objects.empty() ? PickRunEnd::nothing_found : PickRunEnd::no_pick);
    }
  }

  void look() {
    stage(fmt::format("look {}", run_.looks.size() + 1));
    surfaces_ = surfaces_of(cell_->tabletop());
    present_ = cell_->present();
    TablePerception perception(options_);
    const TakenLook taken = camera_->take(*cell_, perception);
    stage(fmt::format("objects of look {}", run_.looks.size() + 1));
    belief_ = perception.finish(gripper_);
    PickLook look = perception.look();
    look.robot_share = taken.robot_share;
    look.touched = taken.touched;
    look.is_enough = taken.is_enough;
    look.time = cell_->time();
    look.present = present_.size();
    look.found = belief_.scene.objects.size();
    look.grasps = belief_.grasps.size();
    for (const StageTime& time : look.times) timer_.add(time.stage, time.seconds);
    recorder_.add(belief_, cell_->time());
    tell_look(look);
    run_.looks.push_back(std::move(look));
    bin_.add_walls_to(belief_.scene.obstacles);  // the robot knows where the bin is
  }

  void tell_look(const PickLook& look) {
    tell(fmt::format("look {}: {} {} in {} {}{}, {} grasps", run_.looks.size() + 1, look.found,
                     look.found == 1 ? "object" : "objects", look.frames,
                     look.frames == 1 ? "image" : "images",
                     look.is_enough ? ", which is enough" : "", look.grasps));
    not_looked_.clear();
    if (look.robot_share > options_.look.max_robot_share) {
      const std::string blocked =
          fmt::format("the robot covers {:.0f} % of the images: an arm blocks the camera",
                      100.0 * look.robot_share);
      tell(blocked, RecordedOutcome::failure);
      if (look.found == 0) not_looked_ = blocked;
    }
    if (!look.touched.empty()) tell(look.touched + " during the look", RecordedOutcome::failure);
    if (look.fused < look.frames)
      tell(fmt::format("the camera was lost in {} of {} images", look.frames - look.fused,
                       look.frames));
  }

  PickScene scene() const { return {robot_, arm_, gripper_, belief_.scene, bin_, options_}; }

  PickChoice choose() {
    stage(fmt::format("motions of look {}", run_.looks.size()));
    StageTimer timer;
    PickChoice choice = choose_pick(scene(), belief_, cell_->target(), failed_, timer);
    PickLook& look = run_.looks.back();
    for (const StageTime& time : timer.stages()) {
      add_to_sums(look.times, time);
      timer_.add(time.stage, time.seconds);
    }
    look.no_pick = choice.no_pick;
    if (!choice.planned) tell(choice.no_pick, RecordedOutcome::failure);
    ledger_.note(belief_, choice.fates, present_, surfaces_);
    return choice;
  }

  void attempt(const PlannedPick& planned) {
    const auto aim = ledger_.true_object(static_cast<Index>(planned.grasp.object));
    PickAttempt attempt;
    attempt.look = run_.looks.size() - 1;
    attempt.grasp = planned.grasp;
    attempt.object = aim ? cell_->object(*aim).object.name : "nothing that is there";
    attempt.begin = cell_->time();
    stage(fmt::format("pick {}: {}", run_.attempts.size() + 1, attempt.object));
    PickOutcome outcome;
    outcome.end = AttemptEnd::diverged;
    try {
      outcome = execute_pick(*cell_, arm_.arm, planned, options_.execution);
    } catch (const PhysicsDiverged&) {
      note_attempt(attempt, outcome, aim);
      throw;
    }
    note_attempt(attempt, outcome, aim);
    go_home(planned.grasp.object, outcome.end == AttemptEnd::in_bin);
    settle();
  }

  void note_attempt(PickAttempt& attempt, const PickOutcome& outcome,
                    const std::optional<std::size_t>& aim) {
    attempt.end = outcome.end;
    attempt.detail = outcome.detail;
    attempt.finish = cell_->time();
    for (const std::size_t i : outcome.in_bin) ledger_.note_in_bin(i);
    const bool succeeded = outcome.end == AttemptEnd::in_bin;
    if (!succeeded) failed_.add(tip_point(attempt.grasp, gripper_));
    if (!outcome.in_bin.empty() && run_.to_first.empty()) {
      for (const StageTime& time : timer_.stages()) add_to_sums(run_.to_first, time);
    }
    tell(fmt::format("{}: {} (grasp: {}, quality {:.2f}){}{}", attempt.object,
                     description(outcome.end), to_string(attempt.grasp.source),
                     attempt.grasp.quality, attempt.detail.empty() ? "" : ", ", attempt.detail),
         succeeded ? RecordedOutcome::success : RecordedOutcome::failure);
    ledger_.note_attempt(attempt, aim);
    run_.attempts.push_back(attempt);
  }

  /// `object`: of the belief, the one that was grasped. If it is not gone, it may still be at the
  /// hand: a way that avoids where it was comes first.
  void go_home(int object, bool is_gone) {
    stage("motion home");
    PlaceMotion home = plan_home(scene(), cell_->target(), is_gone ? object : -1);
    if (!home.path && !is_gone) home = plan_home(scene(), cell_->target(), object);
    if (!home.path) tell("no free way home is known, the arm goes straight: " + home.obstacle);
    const auto path = home.path ? home.path : straight_home();
    if (!path) return;
    ContactWatch watch(*cell_);
    follow_watched(*cell_, arm_.arm, *path, watch);
    if (!watch.touched().empty())
      tell(watch.touched() + " on the way home", RecordedOutcome::failure);
  }

  /// None if the arm is at home.
  std::optional<TimedPath> straight_home() const {
    const std::vector<Eigen::VectorXd> straight{arm_positions(arm_.arm, cell_->target()),
                                                arm_positions(arm_.arm, robot_.home)};
    if ((straight[0] - straight[1]).norm() == 0.0) return std::nullopt;
    return time_optimal_trajectory(straight,
                                   motion_limits(robot_.model, arm_.arm, options_.pick.line_speed));
  }

  void settle() {
    for (const std::size_t i : cell_->settle()) {
      ledger_.note_fallen(i);
      tell(cell_->object(i).object.name + " left the table", RecordedOutcome::failure);
    }
  }

  void finish() {
    if (run_.looks.empty() && not_looked_.empty()) not_looked_ = description(run_.end);
    ledger_.finish(run_, not_looked_);
    tell(description(run_.end),
         run_.end == PickRunEnd::cleared ? RecordedOutcome::success : RecordedOutcome::note);
    if (cell_) run_.duration = cell_->time();
    run_.recording = recorder_.take();
    for (const LeftObject& left : run_.left)
      run_.recording.left.push_back(left.name + ": " + left.reason);
  }

  const PickTable& table_;
  const Robot& robot_;
  const Gripper& gripper_;
  const SimulatedPickOptions& options_;
  const PickObserver& observer_;
  const RobotArm& arm_;
  PickRun run_;
  RobotSolids solids_;
  PickBin bin_;
  TriangleMesh bin_mesh_;
  RunRecorder recorder_;
  FailedAttempts failed_;
  ObjectLedger ledger_;
  std::optional<ArmCell> cell_;
  std::optional<LookTaker> camera_;
  std::string not_looked_;  ///< why nothing is known of the table
  TableBelief belief_;
  StageTimer timer_;                    ///< of all that the robot computes
  std::vector<TriangleMesh> surfaces_;  ///< true, at the last look
  std::vector<std::size_t> present_;    ///< their numbers
};

}  // namespace

PickRun simulate_picks(const PickTable& table, const Robot& robot, const Gripper& gripper,
                       const SimulatedPickOptions& options, const PickObserver& observer) {
  options.validate();
  gripper.validate();
  if (gripper.kind != GripperKind::parallel)
    throw InputError(gripper.name, "a parallel gripper", to_string(gripper.kind));
  return PickLoop(table, robot, gripper, options, observer).run();
}

}  // namespace symscene
