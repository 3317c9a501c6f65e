#include <memory>

#include "commands.hpp"
#include "core/naming.hpp"
#include "cylinder_output.hpp"
#include "gripper_choice.hpp"
#include "io/atomic_file.hpp"
#include "result_page.hpp"
#include "segment_input.hpp"

namespace symscene::app {
namespace {

struct Cylinders {
  SharedOptions shared;
  CylinderOptions options;
  SegmentSource source;
  std::filesystem::path page;
  GripperChoice gripper;

  OptionFields configure() { return configure_options(options, shared.config); }

  void write_page(SegmentInput& input, const CylinderScene& scene, const GraspPlan& plan,
                  const Gripper& hand, Session& session) const {
    const SegmentationResult result = cylinders_as_objects(scene);
    write_result_page(
        page, source.path, result,
        {surface_around(input.surface, result, source.path, session), std::move(input.trajectory)},
        {.grasps = PageGrasps{hand, plan}, .subject = "cylinders", .noun = "cluster"});
  }

  void run() {
    configure();
    source.table.table();                    // before the work
    const Gripper hand = gripper.gripper();  // as well
    require_apart({shared.output, page}, {source.path});
    Session session("cylinders", shared);
    StageTimer timer(session.on_begin());
    SegmentInput input = timer.time("read", [&] { return source.read(SegmentOptions{}, session); });
    const CylinderScene scene = naming(
        source.path, [&] { return fit_cylinders(input.scene, options, session.on_begin()); });
    session.warn(std::span(scene.warnings).subspan(input.scene.warnings.size()));
    const GraspPlan plan = cylinder_grasps(scene, hand, options.grasps);
    for (const auto* stages : {&scene.timings, &plan.timings}) {
      for (const StageTime& stage : *stages) timer.add(stage.stage, stage.seconds);
    }
    timer.time("write", [&] {
      write_file_atomically(shared.output, format_cylinders_json(scene, plan, hand));
      if (!page.empty()) write_page(input, scene, plan, hand, session);
    });
    session.print_line(format_cylinders(scene, plan));
    session.finish({{"output", shared.output},
                    {"clusters", scene.clusters.size()},
                    {"cylinders", cylinder_count(scene)},
                    {"grasps", plan.grasps.size()}},
                   timer.stages());
  }
};

}  // namespace

void add_cylinders(CommandLine& line) {
  const auto state = std::make_shared<Cylinders>();
  Arguments arguments(line, "cylinders",
                      "Fit cylinders to the clusters of a scene, and find grasps around them",
                      "symscene cylinders scene -o cylinders.json --page page.html\n"
                      "  symscene cylinders scene --gripper reflex -o cylinders.json");
  arguments.input(state->source.path, "INPUT",
                  "scene folder, depth image, folder with one frame, or cloud (.ply, .pcd)");
  arguments.output_file(state->shared, "JSON file to write", {".json"});
  state->gripper.add_to(arguments);
  arguments.file("--page", state->page, "also write a page that shows cylinders and grasps");
  state->source.add_to(arguments);
  arguments.run_stages(state);
}

}  // namespace symscene::app
