#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "commands.hpp"
#include "core/number_in.hpp"
#include "gripper_choice.hpp"
#include "io/atomic_file.hpp"
#include "moveit_output.hpp"
#include "object_input.hpp"
#include "pick_table.hpp"
#include "plan_page.hpp"
#include "robot_choice.hpp"
#include "symscene/io/grasps.hpp"
#include "symscene/io/joint_trajectory.hpp"
#include "symscene/motion/pick_survey.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

/// The options of `symscene plan`.
struct PlanOptions {
  double period = 0.01;
  double pause = 1.0;
  PickOptions pick;
  GraspOptions grasps;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("period", self.period, "s", between(1e-4, 1.0), "time between points of the trajectory");
    visit("pause", self.pause, "s", between(0.01, 60.0),
          "rest at the grasp while the gripper closes");
    visit("pick", self.pick);
    visit("grasps", self.grasps);
  }
  void validate() const { check_fields(*this); }
};

/// Grasps to choose from, and what stands around them.
struct PlanInput {
  GraspScene scene;
  Gripper gripper;
  std::vector<Grasp> grasps;         ///< in descending order of quality
  std::vector<std::size_t> numbers;  ///< of these grasps among all
};

struct PlanCommand {
  SharedOptions shared;
  PlanOptions options;
  fs::path path, result;  ///< a grasps.json, or what the objects are read from
  fs::path page;          ///< empty: none is written
  ObjectInput input;
  RobotChoice robot;
  GripperChoice gripper{""};
  MoveItOutput moveit;
  std::string object;
  bool all = false;

  OptionFields configure() { return configure_options(options, shared.config); }

  bool input_is_grasps() const { return fs::is_regular_file(path) && path.extension() == ".json"; }
  bool writes_csv() const { return shared.output.extension() == ".csv"; }

  /// Grasps are of a result, or of a scene; other inputs are themselves what they are made of.
  void resolve_input() {
    if (!input_is_grasps()) {
      if (!result.empty()) throw InputError("--result", "a grasps.json as input", path.string());
      input.source.path = path;
      return;
    }
    if (!gripper.name.empty())
      throw InputError("--gripper", "a scene or result as input",
                       "grasps, which are for a gripper");
    if (result.empty() && input.scene.empty())
      throw InputError(path.string(), "the --scene or --result of its grasps", "neither");
    if (result.empty()) std::swap(result, input.scene);
    input.source.path = result;
  }

  void check_outputs() const {
    moveit.check();
    std::vector<fs::path> inputs = input.paths();
    inputs.push_back(path);
    require_apart({shared.output, moveit.path, moveit.grasping_path, page}, inputs);
  }

  /// Throws InputError unless the objects are those of the grasps.
  void require_same_objects(const GraspFile& file, const GraspScene& scene) const {
    if (file.plan.objects.size() == scene.objects.size()) return;
    throw InputError(path.string() + ": objects",
                     fmt::format("{}, as in {}", scene.objects.size(), input.source.path.string()),
                     std::to_string(file.plan.objects.size()));
  }

  GraspScene read_scene(StageTimer& timer, Session& session) const {
    return input.grasp_scene(input.read(timer, session), options.grasps);
  }

  PlanInput read_grasp_file(StageTimer& timer, Session& session, const RobotArm& arm) const {
    GraspFile file = read_grasps(path);
    const bool is_wanted = !gripper.name.empty() && gripper.gripper().name == file.gripper.name;
    if (!is_wanted && arm.gripper && !has_gripper(arm, file.gripper))
      throw InputError(
          path.string() + ": gripper",
          fmt::format("{}, which the arm has (or --gripper {})", *arm.gripper, file.gripper.name),
          file.gripper.name);
    GraspScene scene = read_scene(timer, session);
    require_same_objects(file, scene);
    return chosen(std::move(scene), file.gripper, file.plan.grasps);
  }

  PlanInput find_grasps(StageTimer& timer, Session& session, const RobotArm& arm) const {
    if (gripper.name.empty() && !arm.gripper)
      throw InputError("--arm", "an arm with a gripper, or --gripper", arm.arm.name);
    const Gripper hand = (gripper.name.empty() ? GripperChoice{*arm.gripper} : gripper).gripper();
    GraspScene scene = read_scene(timer, session);
    GraspPlan plan = timer.time("grasps", [&] { return plan_grasps(scene, hand, options.grasps); });
    return chosen(std::move(scene), hand, plan.grasps);
  }

  /// The grasps of --object, or all.
  PlanInput chosen(GraspScene scene, const Gripper& hand, const std::vector<Grasp>& grasps) const {
    const std::optional<int> wanted = wanted_object(scene.objects.size());
    PlanInput input{std::move(scene), hand, {}, {}};
    for (std::size_t i = 0; i < grasps.size(); ++i) {
      if (wanted && grasps[i].object != *wanted) continue;
      input.grasps.push_back(grasps[i]);
      input.numbers.push_back(i);
    }
    return input;
  }

  std::optional<int> wanted_object(std::size_t objects) const {
    if (object.empty()) return std::nullopt;
    const auto id = number_in<std::size_t>(object);
    if (!id || *id >= objects)
      throw InputError("--object", fmt::format("the number of one of {} objects", objects), object);
    return static_cast<int>(*id);
  }

  void run() {
    configure();
    resolve_input();
    check_outputs();
    const Robot whole = robot.robot();  // before the work
    const RobotArm& arm = robot.arm(whole);
    const Eigen::VectorXd start = robot.start_positions(whole, arm.arm);
    Session session("plan", shared);
    session.warn(whole.warnings);
    StageTimer timer(session.on_begin());
    const PlanInput read =
        input_is_grasps() ? read_grasp_file(timer, session, arm) : find_grasps(timer, session, arm);
    if (const auto warning = robot.check_stand(whole, read.scene.table)) session.warn(*warning);
    session.on_begin()("plan motions");
    const PickSurvey pick = planned(whole, arm, start, read);
    for (const StageTime& stage : pick.timings) timer.add(stage.stage, stage.seconds);
    const std::optional<JointTrajectory> trajectory = trajectory_of(pick, whole, arm, read);
    if (moveit.is_wanted()) {
      session.print_line(timer.time("write for MoveIt", [&] {
        return moveit.write({whole, arm, read.gripper, read.scene, read.grasps, trajectory});
      }));
    }
    if (!page.empty()) {
      timer.time("page", [&] {
        write_page({whole, arm, read.gripper, start, read.scene, read.grasps, read.numbers, pick,
                    trajectory});
      });
    }
    require_motion(session, pick, read);
    timer.time("write", [&] { write(*trajectory, arm, read, pick); });
    const std::size_t number = read.numbers[pick.motion->grasp];
    const Grasp& grasp = read.grasps[pick.motion->grasp];
    session.print_line(format_motion(*pick.motion, number, grasp));
    session.finish({{"output", shared.output},
                    {"grasps", read.grasps.size()},
                    {"reached", pick.reached.size()},
                    {"not_reached", pick.rejected.size()},
                    {"grasp", number},
                    {"object", static_cast<std::uint64_t>(grasp.object)}},
                   timer.stages());
  }

  /// Prints what the arm reaches. Throws InputError if it can take no grasp.
  void require_motion(Session& session, const PickSurvey& pick, const PlanInput& read) const {
    if (!pick.start_contact.empty())
      throw InputError(robot.start.empty() ? robot.name + ": home" : "--start",
                       "joint positions at which the arm can move", pick.start_contact);
    if (read.grasps.empty()) throw InputError(path.string(), "a grasp", "none");
    session.print_line(format_reach(read.grasps, pick.reached, pick.rejected));
    if (!pick.motion)
      throw InputError(path.string(), "a grasp that the arm reaches",
                       fmt::format("none of {}", read.grasps.size()));
  }

  std::vector<GraspNotReached> not_reached(const PickSurvey& pick, const PlanInput& read) const {
    std::vector<GraspNotReached> list;
    for (const RejectedPick& why : pick.rejected)
      list.push_back({read.numbers[why.grasp], read.grasps[why.grasp].object, to_string(why.reason),
                      why.detail});
    return list;
  }

  PickSurvey planned(const Robot& whole, const RobotArm& arm, const Eigen::VectorXd& start,
                     const PlanInput& read) const {
    if (all)
      return survey_picks(whole, arm, read.gripper, start, read.scene, read.grasps, options.pick);
    return as_survey(
        plan_pick(whole, arm, read.gripper, start, read.scene, read.grasps, options.pick));
  }

  std::optional<JointTrajectory> trajectory_of(const PickSurvey& pick, const Robot& whole,
                                               const RobotArm& arm, const PlanInput& read) const {
    if (!pick.motion) return std::nullopt;
    return pick_trajectory(*pick.motion, whole.model, arm.arm, read.gripper,
                           read.grasps[pick.motion->grasp].opening, options.period, options.pause);
  }

  void write_page(const PlanToShow& plan) const {
    write_file_atomically(page, render_plan_page(plan_recording(plan),
                                                 fmt::format("{}: how to pick from {}", robot.name,
                                                             folder_name(input.source.path))));
  }

  void write(const JointTrajectory& trajectory, const RobotArm& arm, const PlanInput& read,
             const PickSurvey& pick) const {
    const Grasp& grasp = read.grasps[pick.motion->grasp];
    if (writes_csv())
      return write_file_atomically(shared.output, format_joint_trajectory_csv(trajectory));
    const TrajectoryPurpose purpose{robot.name, arm.arm.name, read.numbers[pick.motion->grasp],
                                    grasp, not_reached(pick, read)};
    write_file_atomically(shared.output,
                          format_joint_trajectory_json(trajectory, purpose, moveit.version()));
  }
};

}  // namespace

void add_plan(CommandLine& line) {
  const auto state = std::make_shared<PlanCommand>();
  Arguments arguments(
      line, "plan", "Plan how a robot's arm picks an object: a trajectory of its joints",
      "symscene plan grasps.json --robot panda --scene scene -o trajectory.json\n"
      "  symscene plan scene --robot robot.yaml --base 0.4,0,0,90 -o trajectory.csv\n"
      "  symscene plan result --scene scene --robot baxter --object 2 -o trajectory.json\n"
      "  symscene plan grasps.json --result result --moveit moveit.yaml -o trajectory.json");
  arguments.input(state->path, "INPUT",
                  "grasps.json of symscene grasp; or a scene or result, whose grasps are planned "
                  "first");
  arguments.output_file(state->shared, "trajectory to write: .csv, else JSON", {".csv", ".json"});
  state->robot.add_to(arguments);
  arguments.text("--object", "NUMBER", state->object,
                 "number of the object to pick (default: any)");
  arguments.flag("--all", state->all,
                 "judge every grasp, not only up to the first that the arm reaches");
  arguments.text("--gripper", "NAME|FILE", state->gripper.name,
                 "gripper of the grasps that are planned first (default: that of the arm)");
  arguments.folder("--result", state->result, "of grasps: the result folder that they are of");
  state->input.add_to(arguments,
                      "of grasps or of a result: the scene that they were made of; what was never "
                      "seen is an obstacle");
  arguments.file("--page", state->page,
                 "also write a page that plays the motion, with a map of where the arm reaches");
  state->moveit.add_to(arguments);
  arguments.run_stages(state);
}

}  // namespace symscene::app
