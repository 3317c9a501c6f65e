#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "gripper_choice.hpp"
#include "io/atomic_file.hpp"
#include "io/gif_writer.hpp"
#include "robot_choice.hpp"
#include "session.hpp"
#include "simulation/object_choice.hpp"
#include "symscene/picking/run_video.hpp"
#include "symscene/picking/simulated_picks.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;

/// Options of the table, those of the run, and those of its video.
struct PickRunOptions {
  PickTableOptions table;
  SimulatedPickOptions run;
  RunVideoOptions video;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("table", self.table);
    SimulatedPickOptions::visit_fields(self.run, visit);
    visit("video", self.video);
  }
  void validate() const {
    table.validate();
    run.validate();
    video.validate();
  }
};

DirectoryLayout pick_layout() {
  return {"a folder of a run of picks", "run.json", [](const std::string& relative) {
            return relative == "run.json" || relative == "page.html";
          }};
}

struct PickCommand {
  SharedOptions shared;
  PickRunOptions options;
  bool simulate = false;
  std::string robot = "panda";
  ObjectChoice objects;
  std::string method = "symscene";
  std::string views = "sweep";
  fs::path video;  ///< empty: none is written
  std::optional<int> count;
  std::optional<std::uint64_t> seed;

  OptionFields configure() {
    return configure_options(options, shared.config, [&] {
      TabletopOptions& tabletop = options.table.tabletop;
      tabletop.objects = count.value_or(tabletop.objects);
      tabletop.seed = seed.value_or(tabletop.seed);
      options.run.seed = seed.value_or(options.run.seed);
      options.run.method = parse_grasp_method(method);
      options.run.views = parse_look_views(views);
    });
  }

  void check() const {
    if (!simulate)
      throw InputError("--simulate", "this flag, as only simulated tables can be cleared", "none");
    require_physics("--simulate");
    objects.check(shared.output);
    check_video();
    const AtomicDirectory writable(absolute(shared.output), pick_layout());
  }

  void check_video() const {
    if (video.empty()) return;
    if (video.extension() != ".gif")
      throw InputError("--video", "a name that ends in .gif", video.string());
    if (!has_gif())
      throw InputError("--video",
                       "a build with giflib (the package libgif-dev, then configure and build "
                       "again)",
                       "one without");
    if (!fs::is_directory(absolute(video).parent_path()))
      throw InputError("--video", "a file in a folder that exists", video.string());
  }

  PickTable furnish(Session& session) const {
    return objects.furnished(session, [&](std::span<const ObjectModel> models) {
      return furnish_pick_table(models, options.table);
    });
  }

  PickObserver observer(Session& session) {
    return {session.on_begin(), [this, &session](const RecordedEvent& event) {
              if (shared.verbose)
                session.print_line(fmt::format("{:7.2f} s  {}", event.time, event.text));
            }};
  }

  std::string made_by(const OptionFields& fields) const {
    auto json = nlohmann::ordered_json::parse(describe_run("pick", fields));
    json["robot"] = robot;
    json["models"] = objects.name;
    json["method"] = method;
    json["views"] = views;
    return json.dump();
  }

  void write(const PickRun& run, const std::string& description) const {
    AtomicDirectory folder(absolute(shared.output), pick_layout());
    folder.write("run.json", format_pick_run(run, description));
    write_run_page(folder.staging() / "page.html", run.recording,
                   fmt::format("{} clears a table", robot));
    folder.commit();
  }

  void report(const PickRun& run, Session& session) const {
    session.print_line(fmt::format("{}: {} of {} objects in the bin with {} attempts, {}",
                                   shared.output.string(), run.all.in_bin, run.all.placed,
                                   run.attempts.size(), description(run.end)));
    for (const LeftObject& left : run.left)
      session.print_line(fmt::format("  {} is left: {}", left.name, left.reason));
    session.finish({{"output", shared.output},
                    {"objects", run.all.placed},
                    {"in_bin", run.all.in_bin},
                    {"attempts", run.attempts.size()},
                    {"left", run.left.size()}},
                   run.to_first);
  }

  void run() {
    const OptionFields fields = configure();
    check();
    const Robot described = named_robot(robot);
    const Gripper gripper = GripperChoice{*described.grasping_arm().gripper}.gripper();
    Session session("pick", shared);
    session.warn(described.warnings);
    session.on_begin()("table");
    const PickTable table = furnish(session);
    session.warn(table.tabletop.warnings);
    const PickRun run = simulate_picks(table, described, gripper, options.run, observer(session));
    session.warn(run.warnings);
    session.on_begin()("write");
    write(run, made_by(fields));
    if (!video.empty()) {
      session.on_begin()("video");
      write_file_atomically(video, render_run_video(run.recording, options.video));
    }
    report(run, session);
  }
};

}  // namespace

void add_pick(CommandLine& line) {
  const auto state = std::make_shared<PickCommand>();
  Arguments arguments(line, "pick", "Clear a simulated table with a robot arm",
                      "symscene pick --simulate --robot panda --objects household -o run\n"
                      "  symscene pick --simulate --robot baxter --objects ycb --count 4 -o run\n"
                      "  symscene pick --simulate --views next --count 3 -o run");
  arguments.flag("--simulate", state->simulate,
                 "in physics: the only way so far, no real robot is moved");
  arguments.text("--robot", "NAME|FILE", state->robot,
                 "panda, baxter, or a YAML file that describes a robot (default panda)");
  state->objects.add_to(arguments);
  arguments.count(
      "--count", state->count, range_of(state->options, "table.tabletop.objects"),
      fmt::format("number of objects (default {})", state->options.table.tabletop.objects));
  arguments.choice("--method", state->method, {"symscene", "cylinders"},
                   "what proposes grasps: segmented objects, or clusters and bounding cylinders "
                   "(default symscene)");
  arguments.choice("--views", state->views, {"sweep", "next"},
                   "from where the camera looks: along a sweep, or from views that are chosen one "
                   "by one by what is known (default sweep)");
  arguments.file("--video", state->video,
                 "also write the run as an animated GIF: a name that ends in .gif");
  arguments.seed(state->seed, state->options.table.tabletop.seed);
  arguments.output_folder(state->shared, "folder to write: run.json and page.html");
  arguments.run_stages(state);
}

}  // namespace symscene::app
