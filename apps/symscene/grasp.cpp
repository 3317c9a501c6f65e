#include <memory>
#include <utility>

#include "commands.hpp"
#include "grasp_table.hpp"
#include "gripper_choice.hpp"
#include "io/atomic_file.hpp"
#include "object_input.hpp"
#include "result_page.hpp"
#include "session.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/io/grasps.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

struct GraspCommand {
  SharedOptions shared;
  GraspOptions options;
  ObjectInput input;
  fs::path page;
  GripperChoice gripper;

  OptionFields configure() { return configure_options(options, shared.config); }

  void run() {
    configure();
    require_apart({shared.output, page}, input.paths());
    const Gripper hand = gripper.gripper();  // before the work
    input.with_page = !page.empty();
    Session session("grasp", shared);
    StageTimer timer(session.on_begin());
    SegmentedInput read = input.read(timer, session);
    const GraspPlan plan = plan_grasps(input.grasp_scene(read, options), hand, options);
    for (const StageTime& stage : plan.timings) timer.add(stage.stage, stage.seconds);
    timer.time("write", [&] {
      write_file_atomically(shared.output, format_grasps_json(plan, hand));
      if (!page.empty()) {
        write_result_page(page, input.source.path, read.result, std::move(read.around),
                          {.grasps = PageGrasps{hand, plan}, .subject = "grasps"});
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
  arguments.input(state->input.source.path, "INPUT",
                  "scene folder, depth image, folder with one frame, or cloud, which is segmented "
                  "first; or result folder");
  arguments.output_file(state->shared, "JSON file to write", {".json"});
  state->gripper.add_to(arguments);
  arguments.file("--page", state->page, "also write a page that shows the grasps");
  state->input.add_to(arguments,
                      "scene folder of a result: what was never seen counts as occupied");
  arguments.run_stages(state);
}

}  // namespace symscene::app
