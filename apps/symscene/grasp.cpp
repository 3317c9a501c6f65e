#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "commands.hpp"
#include "grasp_table.hpp"
#include "gripper_choice.hpp"
#include "io/atomic_file.hpp"
#include "result_page.hpp"
#include "segment_input.hpp"
#include "session.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/io/grasps.hpp"
#include "symscene/io/result.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

/// Segmented objects, as the planner and as the page sees them.
struct SegmentedInput {
  GraspScene scene;
  SegmentationResult result;
  Surroundings around;  ///< empty without a page
};

struct GraspCommand {
  SharedOptions shared;
  GraspOptions options;
  SegmentSource source;
  fs::path scene, page;
  GripperChoice gripper;

  OptionFields configure() { return configure_options(options, shared.config); }

  bool input_is_result() const { return fs::exists(source.path / "objects.json"); }

  GraspScene graspable(const SegmentationResult& result, const Scene* around) const {
    return naming(source.path, [&] { return grasp_scene(result, around, options); });
  }

  void warn_without_occupancy(const fs::path& path, Session& session) const {
    session.warn(
        fmt::format("{}: no occupancy, so that space which was never seen counts as free for the "
                    "gripper",
                    path.string()));
  }

  /// Those of earlier versions have none.
  void warn_without_surfaces(const SegmentationResult& result, Session& session) const {
    const bool has_one =
        std::any_of(result.surfaces.begin(), result.surfaces.end(),
                    [](const ObjectSurface& s) { return s.mesh.triangles.rows() > 0; });
    if (result.objects.empty() || has_one) return;
    session.warn(fmt::format(
        "{}: its objects have no closed surfaces, which grasps need; symscene segment writes them",
        source.path.string()));
  }

  /// The objects of a result, with the free space of its scene if that is given.
  SegmentedInput of_result(StageTimer& timer, Session& session) const {
    return timer.time("read", [&] {
      SegmentedInput input;
      input.result = read_result(source.path);
      if (!page.empty()) input.around = read_result_surroundings(source.path);
      warn_without_surfaces(input.result, session);
      if (scene.empty()) {
        session.warn(
            fmt::format("{}: a result holds no occupancy, so that space which was never "
                        "seen counts as free; --scene names its scene",
                        source.path.string()));
        input.scene = graspable(input.result, nullptr);
      } else {
        const Scene around = read_scene(scene);
        session.warn(around.warnings);
        if (!around.occupancy) warn_without_occupancy(scene, session);
        input.scene = graspable(input.result, &around);
      }
      return input;
    });
  }

  /// The objects that segmentation with default options finds.
  SegmentedInput of_scene(StageTimer& timer, Session& session) const {
    if (!scene.empty()) throw InputError("--scene", "a result folder as input", "a scene");
    SegmentInput read = timer.time("read", [&] { return source.read(SegmentOptions{}, session); });
    SegmentedInput input;
    input.result = timer.time("segment", [&] {
      if (read.scene.cloud.empty()) return nothing_found(read.scene);
      return naming(source.path, [&] { return segment_scene(read.scene); });
    });
    session.warn(std::span(input.result.warnings).subspan(read.scene.warnings.size()));
    if (!read.scene.occupancy && !read.scene.cloud.empty())
      warn_without_occupancy(source.path, session);
    input.scene = graspable(input.result, &read.scene);
    if (!page.empty()) {
      input.around = {surface_around(read.surface, input.result, source.path, session),
                      std::move(read.trajectory)};
    }
    return input;
  }

  void check_outputs() const {
    require_not_input(shared.output, source.path);
    if (!scene.empty()) require_not_input(shared.output, scene);
    if (page.empty()) return;
    require_not_input(page, source.path);
    require_not_input(page, shared.output);
    if (!scene.empty()) require_not_input(page, scene);
  }

  void run() {
    configure();
    check_outputs();
    const Gripper hand = gripper.gripper();  // before the work
    Session session("grasp", shared);
    StageTimer timer(session.on_begin());
    SegmentedInput input = input_is_result() ? of_result(timer, session) : of_scene(timer, session);
    const GraspPlan plan = plan_grasps(input.scene, hand, options);
    for (const StageTime& stage : plan.timings) timer.add(stage.stage, stage.seconds);
    timer.time("write", [&] {
      write_file_atomically(shared.output, format_grasps_json(plan, hand));
      if (!page.empty()) {
        write_result_page(page, source.path, input.result, std::move(input.around),
                          PageGrasps{hand, plan});
      }
    });
    session.print_line(format_grasps(plan));
    session.finish({{"output", shared.output},
                    {"objects", plan.objects.size()},
                    {"grasps", plan.grasps.size()},
                    {"graspable", graspable_objects(plan)}},
                   timer.stages());
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
  state->gripper.add_to(arguments);
  arguments.folder("--scene", state->scene,
                   "scene folder of a result: what was never seen counts as occupied");
  arguments.file("--page", state->page, "also write a page that shows the grasps");
  arguments.sequence_options(state->source.sequence);
  state->source.table.add_to(arguments, "the table plane a,b,c,d with ax + by + cz + d = 0");
  state->source.sensor.add_to(arguments);
  arguments.threads(state->shared);
  arguments.reporting(state->shared);
  arguments.config(state->shared, [state] { return state->configure(); });
  arguments.run([state] { state->run(); });
}

}  // namespace symscene::app
