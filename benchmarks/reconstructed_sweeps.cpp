// Simulates hand-held sweeps, reconstructs them by tracking, segments and compares: see README.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>

#include "program.hpp"
#include "simulated_sweeps.hpp"
#include "simulation/true_surface.hpp"
#include "symscene/core/thread_limit.hpp"
#include "symscene/dataset/swept_scene.hpp"
#include "symscene/ground_truth/truth_file.hpp"
#include "symscene/io/result.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "tables.hpp"

namespace symscene::bench {
namespace {

struct Arguments {
  SweepArguments sweeps{.sweeps = 10, .frames = 200, .min_objects = 4, .max_objects = 12};
  std::filesystem::path save;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Distances of the reconstructed surface from the true surfaces.
SurfaceErrors errors_of(const SweptScene& sweep, const Tabletop& tabletop) {
  const SceneTruth moved = transformed(tabletop_truth(tabletop), sweep.T_scene_world);
  std::vector<TriangleMesh> meshes;
  for (const PlacedObject& placed : tabletop.objects) meshes.push_back(placed.object.mesh);
  return surface_errors(sweep.surface.vertices, placed_meshes(moved, meshes), moved.table);
}

/// Time of reconstruction, without rendering and the transfer of ground truth. [s]
double seconds_of(const SweptScene& sweep) {
  double seconds = 0.0;
  for (const StageTime& time : sweep.stages) {
    if (time.stage != "render" && time.stage != "ground truth") seconds += time.seconds;
  }
  return seconds;
}

void run_sweep(const Arguments& arguments, const std::vector<ObjectModel>& models, int i,
               SceneScore& total) {
  const SweepOptions options = arguments.sweeps.options(i);
  const Tabletop tabletop = table_of(options, models);
  const SweptScene sweep = reconstruct_sweep(tabletop, options);
  const SurfaceErrors surface = errors_of(sweep, tabletop);
  const auto start = std::chrono::steady_clock::now();
  const SegmentationResult result = segment_scene(sweep.scene, PipelineOptions{});
  SceneScore score = evaluate(sweep.scene, sweep.truth, result);
  score.seconds = seconds_since(start);
  total += score;
  const std::string name = fmt::format("seed {}", options.tabletop.seed);
  fmt::print("{}", scene_row(name, score));
  fmt::print(
      "    {} of {} frames, {:.1f} per second; path {:.2f} m: absolute error {:.2f} mm, drift "
      "{:.2f} "
      "mm; surface: median {:.2f} mm, 95 % {:.2f} mm\n",
      sweep.fused, options.camera.frames, options.camera.frames / seconds_of(sweep),
      sweep.trajectory.length, 1e3 * sweep.trajectory.absolute, 1e3 * sweep.trajectory.drift,
      1e3 * surface.median, 1e3 * surface.percentile_95);
  std::fflush(stdout);
  if (arguments.save.empty()) return;
  const std::filesystem::path folder =
      arguments.save / fmt::format("seed{}", options.tabletop.seed);
  write_scene(folder / "scene", sweep.scene, {.truth_json = format_truth(sweep.truth)});
  write_result(folder / "result", result);
}

void run(const Arguments& arguments) {
  const ThreadLimit limit(arguments.sweeps.threads);
  const ModelFolder folder = arguments.sweeps.models();
  for (const std::string& warning : folder.warnings) fmt::print(stderr, "{}\n", warning);
  fmt::print("{}", scene_header());
  SceneScore total;
  for (int i = 0; i < arguments.sweeps.sweeps; ++i) run_sweep(arguments, folder.models, i, total);
  fmt::print("{}\n{}", scene_row("all", total), kind_table(total));
}

}  // namespace
}  // namespace symscene::bench

int main(int argc, char** argv) {
  symscene::bench::Arguments arguments;
  CLI::App app{"Reconstructs simulated sweeps, segments them and compares with the ground truth."};
  arguments.sweeps.add_to(app);
  app.add_option("--save", arguments.save, "folder for every scene and its result");
  CLI11_PARSE(app, argc, argv);
  arguments.sweeps.complete();
  return symscene::bench::exit_code_of("symscene_bench_sweeps", [&] {
    symscene::bench::run(arguments);
    return 0;
  });
}
