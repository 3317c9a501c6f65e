#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands.hpp"
#include "grasp_table.hpp"
#include "io/atomic_file.hpp"
#include "segment_input.hpp"
#include "session.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/io/grasps.hpp"
#include "symscene/io/gripper.hpp"
#include "symscene/io/result.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

/// A built-in gripper, or one of a file.
Gripper chosen_gripper(const std::string& choice) {
  if (fs::path(choice).extension() == ".json") return read_gripper(choice);
  return named_gripper(choice);
}

struct GraspCommand {
  SharedOptions shared;
  GraspOptions options;
  SegmentSource source;
  fs::path scene;
  std::string gripper = "panda";

  OptionFields configure() { return configure_options(options, shared.config); }

  bool input_is_result() const { return fs::exists(source.path / "objects.json"); }

  /// The objects of a result, with the free space of its scene if that is given.
  GraspScene of_result(StageTimer& timer, Session& session) const {
    return timer.time("read", [&] {
      const SegmentationResult result = read_result(source.path);
      if (!scene.empty()) {
        const Scene around = read_scene(scene);
        return grasp_scene(result, &around, options);
      }
      session.warn(
          fmt::format("{}: a result holds no occupancy, so that space which was never "
                      "seen counts as free; --scene names its scene",
                      source.path.string()));
      return grasp_scene(result, nullptr, options);
    });
  }

  /// The objects that segmentation with default options finds.
  GraspScene of_scene(StageTimer& timer, Session& session) const {
    if (!scene.empty()) throw InputError("--scene", "a result folder as input", "a scene");
    const SegmentInput input =
        timer.time("read", [&] { return source.read(SegmentOptions{}, session); });
    const SegmentationResult result = timer.time(
        "segment", [&] { return naming(source.path, [&] { return segment_scene(input.scene); }); });
    session.warn(std::span(result.warnings).subspan(input.scene.warnings.size()));
    return grasp_scene(result, &input.scene, options);
  }

  void run() {
    configure();
    require_not_input(shared.output, source.path);
    if (!scene.empty()) require_not_input(shared.output, scene);
    const Gripper hand = chosen_gripper(gripper);  // before the work
    Session session("grasp", shared);
    StageTimer timer(session.on_begin());
    const GraspScene input =
        input_is_result() ? of_result(timer, session) : of_scene(timer, session);
    GraspPlan plan = plan_grasps(input, hand, options);
    std::vector<StageTime> times = timer.stages();
    times.insert(times.end(), plan.timings.begin(), plan.timings.end());
    write_file_atomically(shared.output, format_grasps_json(plan, hand));
    session.print_line(format_grasps(plan));
    session.finish({{"output", shared.output},
                    {"objects", plan.objects.size()},
                    {"grasps", plan.grasps.size()},
                    {"graspable", graspable_objects(plan)}},
                   times);
  }
};

}  // namespace

void add_grasp(CommandLine& line) {
  const auto state = std::make_shared<GraspCommand>();
  Arguments arguments(line, "grasp", "Find grasps of the objects of a scene or a result",
                      "symscene grasp scene --gripper panda -o grasps.json\n"
                      "  symscene grasp result --scene scene --gripper hand.json -o grasps.json");
  arguments.input(state->source.path, "INPUT",
                  "scene folder, depth image, folder with one frame, or cloud, which is segmented "
                  "first; or result folder");
  arguments.required_output(state->shared, "JSON file to write");
  arguments.text("--gripper", state->gripper,
                 fmt::format("{}, or a JSON file that describes a gripper (default panda)",
                             fmt::join(gripper_names(), ", ")));
  arguments.folder("--scene", state->scene,
                   "scene folder of a result: what was never seen counts as occupied");
  arguments.sequence_options(state->source.sequence);
  state->source.table.add_to(arguments, "the table plane a,b,c,d with ax + by + cz + d = 0");
  state->source.sensor.add_to(arguments);
  arguments.threads(state->shared);
  arguments.reporting(state->shared);
  arguments.config(state->shared, [state] { return state->configure(); });
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
