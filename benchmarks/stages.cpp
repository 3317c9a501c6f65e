// Times of single stages on one scene: the scene folder that SYMSCENE_SCENE names, or a simulated
// table of ten objects. Wall time, all cores.
#include <cstdlib>

#include <benchmark/benchmark.h>

#include "core/voxel_sampling.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/grasping/planner.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "symscene/simulation/simulation.hpp"

namespace symscene {
namespace {

const Scene& scene() {
  static const Scene loaded = [] {
    if (const char* folder = std::getenv("SYMSCENE_SCENE")) return read_scene(folder);
    SimulationOptions options;
    options.tabletop.objects = 10;
    return simulate_tabletop(options).scene;
  }();
  return loaded;
}

const PointCloud& cloud() {
  static const PointCloud sampled = voxel_downsample(scene().cloud, 0.005);
  return sampled;
}

const OccupancyGrid& grid() {
  static const OccupancyGrid rasterized =
      rasterize(scene().occupancy.value(), bounding_box(cloud().positions).padded(0.15F));
  return rasterized;
}

void sampling(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(voxel_downsample(scene().cloud, 0.005));
}

void rasterization(benchmark::State& state) {
  const Box box = bounding_box(cloud().positions).padded(0.15F);
  for (auto _ : state) benchmark::DoNotOptimize(rasterize(*scene().occupancy, box));
}

void distance_transform(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(distance_field(grid(), scene().table));
  state.counters["Mvoxels"] = 1e-6 * static_cast<double>(grid().frame.voxels());
}

void adjacency_graph(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(surface_graph(cloud()));
}

void smooth_segments(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(oversegment(cloud(), radius_neighbors(cloud().positions, 0.00866F)));
  }
}

void whole_pipeline(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(segment_scene(scene()));
}

const GraspScene& segmented() {
  static const GraspScene objects = grasp_scene(segment_scene(scene()), &scene());
  return objects;
}

void grasp_planning(benchmark::State& state) {
  const GraspScene& objects = segmented();
  for (auto _ : state) benchmark::DoNotOptimize(plan_grasps(objects, panda_hand()));
  state.counters["objects"] = static_cast<double>(objects.objects.size());
}

BENCHMARK(sampling)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(rasterization)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(distance_transform)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(adjacency_graph)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(smooth_segments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(whole_pipeline)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(grasp_planning)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
}  // namespace symscene

BENCHMARK_MAIN();
