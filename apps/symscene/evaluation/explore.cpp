#include <memory>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "io/atomic_file.hpp"
#include "session.hpp"
#include "simulation/object_choice.hpp"
#include "symscene/exploration/exploration_output.hpp"
#include "symscene/io/result.hpp"
#include "symscene/io/scene.hpp"
#include "workflow/score_models.hpp"

namespace symscene::app {
namespace {

DirectoryLayout exploration_layout() {
  return {"a folder of an exploration", "exploration.json", [](const std::string& relative) {
            return relative == "exploration.json" || relative == "page.html" ||
                   relative.starts_with("scene/") || relative.starts_with("result/");
          }};
}

std::vector<std::string> policy_names() {
  std::vector<std::string> names;
  for (const ExplorationPolicy policy : exploration_policies()) names.push_back(to_string(policy));
  return names;
}

struct ExploreCommand {
  SharedOptions shared;
  TableExplorationOptions options;
  bool simulate = false;
  ObjectChoice objects;
  std::string kind = to_string(ClutterKind::packed);
  std::string policy = to_string(ExplorationPolicy::symmetry);
  std::optional<int> count;
  std::optional<int> views;
  std::optional<std::uint64_t> seed;

  OptionFields configure() {
    return configure_options(options, shared.config, [&] {
      options.objects = count.value_or(options.objects);
      options.views = views.value_or(options.views);
      options.seed = seed.value_or(options.seed);
      options.kind = parse_clutter_kind(kind);
      options.policy = parse_exploration_policy(policy);
    });
  }

  void check() const {
    if (!simulate)
      throw InputError("--simulate", "this flag, as only simulated tables can be explored", "none");
    if (needs_physics(options, objects.is_folder()))
      require_physics(objects.is_folder() ? "--objects" : "--scene",
                      "; without it there are household objects side by side");
    objects.check(shared.output);
    const AtomicDirectory writable(absolute(shared.output), exploration_layout());
  }

  Tabletop furnish(Session& session) const {
    return objects.furnished(session, [&](std::span<const ObjectModel> models) {
      return furnish_exploration(models, options);
    });
  }

  std::string made_by(const OptionFields& fields) const {
    auto json = nlohmann::ordered_json::parse(describe_run("explore", fields));
    json["models"] = objects.name;
    json["scene"] = kind;
    json["policy"] = policy;
    return json.dump();
  }

  void write(const TableExploration& exploration, const Tabletop& table,
             const std::string& description) const {
    AtomicDirectory folder(absolute(shared.output), exploration_layout());
    folder.write("exploration.json", format_exploration_json(exploration, table, description));
    Trajectory trajectory;
    for (const ExploredView& view : exploration.views)
      trajectory.push_back({static_cast<double>(trajectory.size()), view.T_world_camera});
    write_scene(
        folder.staging() / "scene", exploration.scene,
        {.scene_json = description, .trajectory = &trajectory, .camera = &exploration.camera});
    write_result(folder.staging() / "result", exploration.result, {.trajectory = &trajectory});
    folder.write("page.html", render_exploration_page(exploration_recording(exploration, table),
                                                      fmt::format("Next views by {}", policy)));
    folder.commit();
  }

  static std::vector<StageTime> summed_times(const TableExploration& exploration) {
    std::vector<StageTime> sums;
    for (const ExploredView& view : exploration.views) {
      for (const StageTime& time : view.timings) add_to_sums(sums, time);
    }
    return sums;
  }

  void report(const TableExploration& exploration, const Tabletop& table, Session& session) const {
    session.print_line(
        fmt::format("{}: {}; left unknown:", shared.output.string(), description(exploration.end)));
    for (const std::string& sentence : format_left_unknown(exploration, table))
      session.print_line("  " + sentence);
    const ExploredView& last = exploration.views.back();
    session.finish({{"output", shared.output},
                    {"views", exploration.views.size()},
                    ReportMember::raw("end", fmt::format("\"{}\"", to_string(exploration.end))),
                    {"objects", last.objects.size()},
                    ReportMember::raw("observed", fmt::format("{:.4f}", last.step.observed)),
                    ReportMember::raw("completed", fmt::format("{:.4f}", last.step.completed))},
                   summed_times(exploration));
  }

  void run() {
    const OptionFields fields = configure();
    check();
    read_score_models(options.pipeline.models);
    Session session("explore", shared);
    session.on_begin()("table");
    const Tabletop table = furnish(session);
    session.warn(table.warnings);
    std::size_t number = 0;
    const auto tell = [&](const ExploredView& view) {
      session.print_line(format_explored_view(view, ++number, options.policy));
    };
    const TableExploration exploration = explore_table(table, options, {session.on_begin(), tell});
    session.on_begin()("write");
    write(exploration, table, made_by(fields));
    report(exploration, table, session);
  }
};

}  // namespace

void add_explore(CommandLine& line) {
  const auto state = std::make_shared<ExploreCommand>();
  Arguments arguments(line, "explore",
                      "Look at a simulated scene, choose the next view, and look again",
                      "symscene explore --simulate -o exploration\n"
                      "  symscene explore --simulate --objects ycb --scene pile --policy random "
                      "--views 6 -o random");
  arguments.flag("--simulate", state->simulate,
                 "on a simulated table: the only way so far, no real camera is moved");
  arguments.choice("--policy", state->policy, policy_names(),
                   "by what the next view is chosen: surface that symmetries infer and leave open, "
                   "voxels that were never seen, the next on an arc, at random, or by the ground "
                   "truth (default symmetry)");
  state->objects.add_to(arguments);
  arguments.choice("--scene", state->kind, {"packed", "pile"},
                   "upright objects side by side, or dropped in any orientation (default packed)");
  arguments.count("--count", state->count, range_of(state->options, "objects"),
                  fmt::format("number of objects (default {})", state->options.objects));
  arguments.count(
      "--views", state->views, range_of(state->options, "views"),
      fmt::format("views after which it ends at the latest (default {})", state->options.views));
  arguments.seed(state->seed, state->options.seed);
  arguments.output_folder(state->shared,
                          "folder to write: exploration.json, page.html, and the last scene and "
                          "result");
  arguments.run_stages(state);
}

}  // namespace symscene::app
