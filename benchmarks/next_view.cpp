// Scenes of the clutter benchmark, looked at one view after the other: what is known after each
// view, by the policy that chooses them.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "program.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/exploration/exploration_report.hpp"
#include "symscene/physics/physics_world.hpp"
#include "symscene/simulation/scanned_models.hpp"

namespace {

using namespace symscene;

struct Arguments {
  std::filesystem::path objects, steps, report;
  std::vector<std::filesystem::path> earlier;
  std::string share = "all", kind = "packed";
  std::vector<std::string> policies;
  int scenes = 50;
  int first = 0;
  std::size_t threads = 2;
  bool verbose = false;
  ExplorationOptions options;
};

void declare(CLI::App& app, Arguments& a) {
  app.add_option("--objects", a.objects,
                 "folder with NAME.urdf, its surface and convex parts; of tables: of meshes in "
                 "metres (.ply, .obj)");
  app.add_option("--share", a.share,
                 "objects by the hash of their name: all, fitting, held-out; of tables: all")
      ->capture_default_str();
  app.add_option("--scene", a.kind, "packed, pile or table: scanned objects")
      ->check(CLI::IsMember({"packed", "pile", "table"}))
      ->capture_default_str();
  app.add_option("--scenes", a.scenes, "scenes")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--first", a.first, "number of the first scene")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--seed", a.options.seed, "seed of all scenes")->capture_default_str();
  app.add_option("--count", a.options.objects, "objects per scene")->capture_default_str();
  app.add_option("--views", a.options.views, "views per scene")->capture_default_str();
  app.add_option("--spread", a.options.drop.spread,
                 "radius of the disc over which objects are dropped onto tables [m]")
      ->capture_default_str();
  app.add_option("--grasp-after", a.options.grasp_after,
                 "views after which the best grasp of the least visible object is tried; 0: never")
      ->capture_default_str();
  app.add_option("--policy", a.policies,
                 "symmetry, unknown-voxels, rear-side-voxels, fixed-arc, random or oracle; several "
                 "are compared (default: all)");
  NextViewOptions& choice = a.options.next_view;
  app.add_option("--explained-weight", choice.explained_weight,
                 "weight of inferred surface that a symmetry explains")
      ->capture_default_str();
  app.add_option("--dispute-weight", choice.dispute_weight, "weight of disputed surface")
      ->capture_default_str();
  app.add_option("--unknown-weight", choice.unknown_weight, "weight of the border of the unknown")
      ->capture_default_str();
  app.add_flag("!--exact", a.options.noise.enabled, "depth images without noise");
  app.add_option("--steps", a.steps, "CSV file to write: one line per view");
  app.add_option("--report", a.report, "HTML page to write: curves with intervals, and tables");
  app.add_option(
      "--read", a.earlier,
      "CSV file that --steps wrote: reported together with others, of any kind of scene, "
      "and nothing is explored; can be repeated");
  app.add_option("--threads", a.threads, "at most so many threads")->capture_default_str();
  app.add_flag("-v,--verbose", a.verbose, "one line per scene and policy");
}

void print_exploration(const Exploration& e) {
  fmt::print("scene {:3} {:<18} observed", e.scene, to_string(e.policy));
  for (const ExplorationStep& step : e.steps) fmt::print(" {:.3f}", step.observed);
  fmt::print(", completed");
  for (const ExplorationStep& step : e.steps) fmt::print(" {:.3f}", step.completed);
  fmt::print("\n");
  std::fflush(stdout);
}

std::vector<ExplorationPolicy> policies_of(const Arguments& arguments) {
  std::vector<ExplorationPolicy> policies;
  for (const std::string& name : arguments.policies)
    policies.push_back(parse_exploration_policy(name));
  if (!policies.empty()) return policies;
  const auto all = exploration_policies();
  return {all.begin(), all.end()};
}

using SceneExplorer = std::function<std::vector<Exploration>(int scene)>;

SceneExplorer table_explorer(const Arguments& arguments) {
  if (arguments.share != "all")
    throw InputError("--share", "all where --scene is table", arguments.share);
  auto models = read_models(arguments.objects, {}).models;
  fmt::print("{} meshes, tables\n", models.size());
  return [&arguments, models = std::move(models)](int scene) {
    return explore_scanned_table(models, policies_of(arguments), arguments.options, scene);
  };
}

/// Explores the scene of a number; prints what scenes are made of. The arguments must outlive it.
SceneExplorer scene_explorer(Arguments& arguments) {
  if (arguments.kind == scanned_table_kind) return table_explorer(arguments);
  arguments.options.kind = parse_clutter_kind(arguments.kind);
  auto objects = read_clutter_objects(arguments.objects, parse_object_share(arguments.share));
  fmt::print("{} objects ({}), {}\n", objects.size(), arguments.share, arguments.kind);
  return [&arguments, objects = std::move(objects)](int scene) {
    return explore_clutter(objects, policies_of(arguments), arguments.options, scene);
  };
}

/// A file is written after every scene, so that a run that is stopped leaves what it has.
std::vector<Exploration> explore_scenes(Arguments& arguments) {
  if (arguments.objects.empty()) throw InputError("--objects", "a folder", "none");
  const SceneExplorer explore_scene = scene_explorer(arguments);
  fmt::print("{} scenes of {} from {} on, {} views, seed {}\n", arguments.scenes,
             arguments.options.objects, arguments.first, arguments.options.views,
             arguments.options.seed);
  std::vector<Exploration> all;
  for (int scene = arguments.first; scene < arguments.first + arguments.scenes; ++scene) {
    for (const Exploration& e : explore_scene(scene)) {
      if (arguments.verbose) print_exploration(e);
      all.push_back(e);
    }
    if (!arguments.steps.empty())
      write_file_atomically(arguments.steps, format_explorations_csv(all));
  }
  return all;
}

std::vector<Exploration> read_explorations(const Arguments& arguments) {
  std::vector<Exploration> all;
  for (const std::filesystem::path& path : arguments.earlier) {
    for (Exploration& e : parse_explorations_csv(read_file(path), path.string()))
      all.push_back(std::move(e));
  }
  if (!arguments.steps.empty())
    write_file_atomically(arguments.steps, format_explorations_csv(all));
  return all;
}

/// What the page says of its origin.
std::string made_with(const Arguments& arguments) {
  if (!arguments.earlier.empty())
    return fmt::format("From {} tables of earlier runs.", arguments.earlier.size());
  return fmt::format("Seed {}, scenes from {} on, {} objects each, {} objects to draw from.",
                     arguments.options.seed, arguments.first, arguments.options.objects,
                     arguments.share);
}

int run(Arguments& arguments) {
  const bool explores = arguments.earlier.empty();
  if (explores && !has_physics()) {
    fmt::print(stderr, "this build has no physics: libmujoco-dev would add it\n");
    return 1;
  }
  const ThreadLimit limit(arguments.threads);
  const std::vector<Exploration> all =
      explores ? explore_scenes(arguments) : read_explorations(arguments);
  fmt::print("{}", format_exploration_report(all));
  if (!arguments.report.empty())
    write_file_atomically(arguments.report,
                          format_exploration_report_page(all, made_with(arguments)));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Scenes looked at one view after the other, by the policy that chooses the views");
  declare(app, arguments);
  CLI11_PARSE(app, argc, argv);
  return symscene::bench::exit_code_of("symscene_bench_next_view", [&] { return run(arguments); });
}
