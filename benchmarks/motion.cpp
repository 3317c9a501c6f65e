// Planning of picks in simulated scenes: how many are found, why grasps are not taken, and times.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/median.hpp"
#include "path_comparison.hpp"
#include "pick_checks.hpp"
#include "program.hpp"
#include "stopwatch.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/io/robot.hpp"
#include "symscene/motion/pick.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "symscene/simulation/simulation.hpp"

namespace {

using namespace symscene;

struct Arguments {
  std::string robot = "panda";
  std::uint64_t seed = 2000;
  int scenes = 20;
  int objects = 6;
  int frames = 30;
  std::size_t threads = 2;
  bool check = false;
  int oracle = 0;  ///< paths per scene that OMPL searches too
  PickOptions options;
};

/// Sums over the scenes.
struct Tally {
  int found = 0;
  int without_grasp = 0;
  std::array<int, pick_rejections> rejected{};
  std::map<std::string, int> met;                     ///< of grasps not taken: what meets what
  std::map<std::string, std::vector<double>> stages;  ///< wall time [s]
  std::vector<double> processor;                      ///< of a whole pick [s]
  std::vector<double> durations;                      ///< of the motions to the pre-grasp [s]

  void add(const PickResult& pick, double seconds) {
    processor.push_back(seconds);
    for (const StageTime& stage : pick.timings) stages[stage.stage].push_back(stage.seconds);
    for (const RejectedPick& why : pick.rejected) {
      ++rejected.at(static_cast<std::size_t>(why.reason));
      if (why.reason == PickRejection::collision)
        ++met[why.detail.substr(0, why.detail.find(" by "))];
    }
    if (!pick.motion) return;
    ++found;
    durations.push_back(pick.motion->to_pre_grasp.duration());
  }

  bench::PickChecks checks;
  bench::PathComparison paths;

  void print_checks() const {
    fmt::print(
        "{} states at 1 kHz: {} outside limits of position, {} of velocity, {} of "
        "acceleration; ",
        checks.states, checks.positions, checks.velocities, checks.accelerations);
    if (bench::checks_meshes())
      fmt::print("{} in which the arm meets a true mesh, {} in which the held object does\n",
                 checks.objects, checks.held);
    else
      fmt::print("not checked against meshes, for want of FCL\n");
  }

  void print_paths() const {
    fmt::print(
        "{} pairs of random free positions: {} paths found by ours, {} by OMPL in ten times "
        "the time, {} by OMPL alone\n",
        paths.pairs, paths.ours, paths.oracle, paths.oracle_alone);
    print_row("path between them", paths.seconds);
  }

  void print(int scenes) const {
    fmt::print("{} of {} scenes with a pick, {} without a grasp\n", found, scenes, without_grasp);
    for (std::size_t i = 0; i < pick_rejections; ++i) {
      if (rejected.at(i) > 0)
        fmt::print("  {:>5} grasps not taken: {}\n", rejected.at(i),
                   description(static_cast<PickRejection>(i)));
    }
    for (const auto& [contact, count] : met) fmt::print("  {:>9} {}\n", count, contact);
    fmt::print("{:<28}{:>12}{:>12}\n", "wall time [ms]", "median", "90 %");
    for (const auto& [stage, times] : stages) print_row(stage, times);
    print_row("whole pick (processor)", processor);
    fmt::print("median duration of the motion to the pre-grasp: {:.2f} s\n",
               quantile(durations, 0.5).value_or(0.0));
  }

  static void print_row(const std::string& name, const std::vector<double>& times) {
    fmt::print("{:<28}{:>12.2f}{:>12.2f}\n", name, 1e3 * quantile(times, 0.5).value_or(0.0),
               1e3 * quantile(times, 0.9).value_or(0.0));
  }
};

/// The default bounds on frames per point and voxel would leave little of a first look.
void admit_few_frames(SimulationOptions& options) {
  const int third = (options.camera.frames + 2) / 3;
  options.cloud.min_frames = std::min(options.cloud.min_frames, third);
  options.occupancy.min_hit_frames = std::min(options.occupancy.min_hit_frames, third);
  options.occupancy.min_free_frames = std::min(options.occupancy.min_free_frames, third);
}

void plan_scene(const Arguments& arguments, int scene_number, const Robot& robot,
                const Gripper& gripper, Tally& tally) {
  SimulationOptions options;
  options.tabletop.seed = arguments.seed + static_cast<std::uint64_t>(scene_number);
  options.tabletop.objects = arguments.objects;
  options.camera.frames = arguments.frames;
  admit_few_frames(options);
  const SimulatedScene simulated = simulate_tabletop(options);
  const SegmentationResult result = segment_scene(simulated.scene);
  const GraspScene scene = grasp_scene(result, &simulated.scene);
  const GraspPlan grasps = plan_grasps(scene, gripper);
  if (grasps.grasps.empty()) {
    ++tally.without_grasp;
    return;
  }
  PickResult pick;
  const Seconds time = seconds([&] {
    pick = plan_pick(robot, robot.grasping_arm(), gripper, robot.home, scene, grasps.grasps,
                     arguments.options);
  });
  tally.add(pick, time.processor);
  bench::compare_paths(robot, gripper, scene, arguments.options, options.tabletop.seed,
                       arguments.oracle, tally.paths);
  bench::PickChecks checks;
  if (arguments.check && pick.motion) {
    checks = bench::check_pick(*pick.motion, robot, robot.grasping_arm(), gripper,
                               grasps.grasps[pick.motion->grasp].opening, simulated.tabletop,
                               arguments.options);
    tally.checks += checks;
  }
  fmt::print("seed {}: {} grasps, {}{}\n", options.tabletop.seed, grasps.grasps.size(),
             pick.motion ? fmt::format("grasp {} taken", pick.motion->grasp) : "no pick",
             pick.start_contact.empty() ? "" : ": " + pick.start_contact);
  if (checks.objects + checks.held > 0)
    fmt::print("  true meshes are met by the arm in {} states, by the held object in {}\n",
               checks.objects, checks.held);
  if (!pick.motion && !pick.rejected.empty())
    fmt::print("  the first: {} {}\n", description(pick.rejected[0].reason),
               pick.rejected[0].detail);
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Planning of picks in simulated scenes: shares, reasons and times");
  app.add_option("--robot", arguments.robot,
                 "panda, baxter or a YAML file that names a built-in gripper")
      ->capture_default_str();
  app.add_option("--seed", arguments.seed, "of the first scene")->capture_default_str();
  app.add_option("--scenes", arguments.scenes, "scenes")->capture_default_str();
  app.add_option("--objects", arguments.objects, "objects per scene")->capture_default_str();
  app.add_option("--frames", arguments.frames, "views of the camera")->capture_default_str();
  app.add_flag("!--never-seen-is-free", arguments.options.obstacles.never_seen,
               "space that was never seen is no obstacle for the arm");
  app.add_flag("--check", arguments.check,
               "check trajectories at 1 kHz against limits and against the true meshes");
  app.add_option("--oracle", arguments.oracle,
                 "so many paths per scene between random free positions, beside OMPL's RRTConnect")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--threads", arguments.threads, "at most so many threads")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  return symscene::bench::exit_code_of("symscene_bench_motion", [&] {
    const ThreadLimit limit(arguments.threads);
    const Robot robot = read_robot(arguments.robot);
    const Gripper gripper = named_gripper(*robot.grasping_arm().gripper);
    Tally tally;
    for (int i = 0; i < arguments.scenes; ++i) plan_scene(arguments, i, robot, gripper, tally);
    tally.print(arguments.scenes);
    if (arguments.check) tally.print_checks();
    if (arguments.oracle > 0) tally.print_paths();
    return 0;
  });
}
