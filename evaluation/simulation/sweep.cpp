#include "symscene/simulation/sweep.hpp"

#include <map>
#include <optional>

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include "core/parallel.hpp"
#include "core/random.hpp"
#include "hand_shake.hpp"
#include "simulation/depth_renderer.hpp"
#include "simulation/erring_camera.hpp"
#include "simulation/tabletop_meshes.hpp"
#include "symscene/core/error.hpp"
#include "tabletop_parts.hpp"

namespace symscene {
namespace {

/// Makes items 0 … count − 1 in parallel and uses them in order, one at a time.
template <class Make, class Use>
void make_in_parallel_use_in_order(std::size_t count, const Make& make, const Use& use) {
  const std::size_t tokens =
      2 + tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  // Only numbers flow through the pipeline, as it does not free its items after an exception. Item
  // i is used before item i + tokens begins.
  std::vector<std::optional<decltype(make(std::size_t{}))>> items(tokens);
  std::size_t next = 0;
  const auto number = [&](tbb::flow_control& flow) -> std::size_t {
    if (next < count) return next++;
    flow.stop();
    return count;
  };
  const auto make_item = [&](std::size_t i) {
    items[i % tokens].emplace(make(i));
    return i;
  };
  const auto use_item = [&](std::size_t i) {
    use(*items[i % tokens]);
    items[i % tokens].reset();
  };
  using tbb::filter_mode;
  tbb::parallel_pipeline(
      tokens, tbb::make_filter<void, std::size_t>(filter_mode::serial_in_order, number) &
                  tbb::make_filter<std::size_t, std::size_t>(filter_mode::parallel, make_item) &
                  tbb::make_filter<std::size_t, void>(filter_mode::serial_in_order, use_item));
}

}  // namespace

void capture_sensor_frames(const Tabletop& tabletop, const SweepOptions& options,
                           const SensorFrameSink& sink) {
  options.validate();
  const CameraIntrinsics camera = options.camera.intrinsics();
  const std::vector<Eigen::Isometry3d> poses =
      shaken(camera_arc(options.camera), options.frame_rate, options.shake, options.tabletop.seed);
  const DepthRenderer renderer(tabletop_meshes(tabletop));
  const ErringCamera erring(camera, options.errors);
  const auto capture = [&](std::size_t i) {
    // Streams 0 and 1 of the seed arrange the tabletop.
    SensorFrame seen =
        add_sensor_noise(erring.render(renderer, tabletop.T_world_table * poses[i]), camera,
                         options.sensor, Random(options.tabletop.seed, i + 2));
    seen.colors = erring.colors(renderer, seen);
    return std::pair(static_cast<double>(i) / options.frame_rate, std::move(seen));
  };
  make_in_parallel_use_in_order(poses.size(), capture,
                                [&](auto& item) { sink(item.first, std::move(item.second)); });
}

void capture_sweep(const Tabletop& tabletop, const SweepOptions& options, const FrameSink& sink) {
  capture_sensor_frames(tabletop, options, [&](double time, SensorFrame&& seen) {
    sink({time, std::move(seen.depth), std::move(seen.colors)}, seen.T_world_camera);
  });
}

std::vector<std::string> mesh_names(const Tabletop& tabletop) {
  std::map<std::string, int> uses;
  std::vector<std::string> names;
  for (const PlacedObject& placed : tabletop.objects) {
    std::string name = placed.object.name;
    while (++uses[name] > 1) name = fmt::format("{}_{}", placed.object.name, uses[name]);
    names.push_back(name);
  }
  return names;
}

SceneTruth tabletop_truth(const Tabletop& tabletop) {
  SceneTruth truth;
  truth.table = tabletop.plane();
  const std::vector<std::string> names = mesh_names(tabletop);
  for (std::size_t i = 0; i < names.size(); ++i) {
    TrueObject object = true_object(tabletop.objects[i]);
    object.mesh = names[i];
    object.T_world_mesh = tabletop.objects[i].T_world_object;
    truth.objects.push_back(std::move(object));
  }
  return truth;
}

}  // namespace symscene
