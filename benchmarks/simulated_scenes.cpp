// Simulates scenes, segments them and compares the results with the ground truth: see README.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>

#include "program.hpp"
#include "scene_cache.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/ground_truth/truth_file.hpp"
#include "symscene/io/result.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "tables.hpp"

namespace symscene::bench {
namespace {

struct Arguments {
  int scenes = 24;
  std::uint64_t seed = 2000;
  int min_objects = 1;
  int max_objects = 12;
  bool upright = false;
  bool json = false;
  std::size_t threads = 0;
  std::filesystem::path cache;
  std::filesystem::path save;
};

/// Scene i has the next seed and the next number of objects, cyclically.
SimulationOptions scene_options(const Arguments& arguments, int i) {
  SimulationOptions options;
  options.tabletop.seed = arguments.seed + static_cast<std::uint64_t>(i);
  options.tabletop.objects =
      arguments.min_objects + i % (arguments.max_objects - arguments.min_objects + 1);
  options.tabletop.random_frame = !arguments.upright;
  return options;
}

struct Run {
  SegmentationResult result;  ///< empty if segmentation failed
  double seconds = 0.0;
  std::string failure;
};

Run timed_segmentation(const Scene& scene) {
  Run run;
  const auto start = std::chrono::steady_clock::now();
  try {
    run.result = segment_scene(scene, PipelineOptions{});
  } catch (const std::exception& error) {
    run.failure = error.what();
  }
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

void save(const std::filesystem::path& folder, const TrueScene& scene,
          const SegmentationResult& result) {
  write_scene(folder / "scene", scene.scene, {.truth_json = format_truth(scene.truth)});
  write_result(folder / "result", result);
}

/// Adds the score of a scene to the total. Returns whether segmentation succeeded.
bool run_scene(const Arguments& arguments, int i, SceneScore& total) {
  const SimulationOptions options = scene_options(arguments, i);
  const TrueScene scene = simulated_scene(options, arguments.cache);
  const Run run = timed_segmentation(scene.scene);
  const std::string seed = std::to_string(options.tabletop.seed);
  SceneScore score = evaluate(scene.scene, scene.truth, run.result);
  score.seconds = run.seconds;
  total += score;
  if (!run.failure.empty()) fmt::print(stderr, "seed {}: {}\n", seed, run.failure);
  if (!arguments.save.empty()) save(arguments.save / ("seed" + seed), scene, run.result);
  if (!arguments.json) fmt::print("{}", scene_row("seed " + seed, score));
  std::fflush(stdout);
  return run.failure.empty();
}

/// The number of scenes on which segmentation failed.
int run(const Arguments& arguments) {
  const ThreadLimit limit(arguments.threads);
  if (!arguments.json) fmt::print("{}", scene_header());
  SceneScore total;
  int failures = 0;
  for (int i = 0; i < arguments.scenes; ++i) failures += run_scene(arguments, i, total) ? 0 : 1;
  const auto scenes = static_cast<std::size_t>(arguments.scenes);
  if (arguments.json) {
    fmt::print("{}", json_line(arguments.seed, scenes, total));
  } else {
    fmt::print("{}\n{}", scene_row("all", total), kind_table(total));
  }
  return failures;
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{"Segments simulated scenes and compares the results with the ground truth."};
  app.add_option("--scenes", arguments.scenes, "number of scenes")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", arguments.seed, "seed of the first scene")->capture_default_str();
  app.add_option("--min-objects", arguments.min_objects, "fewest objects")
      ->check(CLI::Range(1, 15));
  app.add_option("--max-objects", arguments.max_objects, "most objects")->check(CLI::Range(1, 15));
  app.add_flag("--upright", arguments.upright, "z is up, instead of a random frame");
  app.add_flag("--json", arguments.json, "print the totals only, as one line of JSON");
  app.add_option("--threads", arguments.threads, "bound on the threads, 0 for all cores");
  app.add_option("--cache", arguments.cache, "folder of scenes that need not be simulated again");
  app.add_option("--save", arguments.save, "folder for every scene and its result");
  CLI11_PARSE(app, argc, argv);
  if (arguments.max_objects < arguments.min_objects) arguments.max_objects = arguments.min_objects;
  return symscene::bench::exit_code_of(
      "symscene_bench_simulated", [&] { return symscene::bench::run(arguments) == 0 ? 0 : 1; });
}
