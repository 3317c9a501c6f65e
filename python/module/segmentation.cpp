#include <optional>
#include <string>

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "camera_reading.hpp"
#include "handles.hpp"
#include "option_reading.hpp"
#include "running.hpp"
#include "scenes.hpp"
#include "symscene/pipeline/pipeline.hpp"
#include "symscene/tabletop/cloud_scene.hpp"
#include "symscene/workflow/scene_input.hpp"
#include "symscene/workflow/segment_options.hpp"
#include "workflow/plane_fallback.hpp"
#include "workflow/score_models.hpp"

namespace symscene::python {
namespace {

SegmentOptions segment_options(const std::string& json) {
  SegmentOptions options;
  set_options(options, json);
  read_score_models(options.pipeline.models);
  options.validate();
  return options;
}

/// The objects of a scene. Its timings come first.
SegmentationResult objects_of(const SceneData& data, const PipelineOptions& options,
                              const StageTimer::OnBegin& on_begin) {
  if (data.scene.cloud.empty()) return nothing_found(data.scene);
  SegmentationResult result = segment_scene(data.scene, options, on_begin);
  result.timings.insert(result.timings.begin(), data.timings.begin(), data.timings.end());
  return result;
}

ResultHandle segment_known(const SceneHandle& scene, const std::string& json,
                           const py::object& progress, int threads) {
  const SegmentOptions options = segment_options(json);
  const Running running(progress, threads);
  return running.without_gil([&] {
    return make_result(objects_of(*scene.data, options.pipeline, running.on_begin()), scene.data);
  });
}

/// A cloud with its table, if it has one, as a scene. Where no point is on the given plane, the
/// cloud is that of the objects.
Scene scene_of_cloud(const CloudHandle& handle, const OccupancyHandle* occupancy,
                     const KnownTable& table, const SegmentOptions& options) {
  Scene scene = even_if_plane_misses(table.with({}), [&](const TablePrior& known) {
                  return cloud_scene(*handle.cloud, handle.viewpoint, known,
                                     {options.cloud_normals, options.view.scene});
                }).scene;
  if (table.plane && !scene.table) scene = {*handle.cloud, {}, table.plane, {}};
  if (occupancy != nullptr) scene.occupancy = *occupancy->map;
  return scene;
}

ResultHandle segment_cloud(const CloudHandle& cloud, const OccupancyHandle* occupancy,
                           py::handle table, bool any_up, const std::string& json,
                           const py::object& progress, int threads) {
  const SegmentOptions options = segment_options(json);
  const KnownTable known = table_from(table, any_up);
  const Running running(progress, threads);
  return running.without_gil([&] {
    StageTimer timer(running.on_begin());
    SceneData data;
    data.scene =
        timer.time("find table", [&] { return scene_of_cloud(cloud, occupancy, known, options); });
    data.timings = timer.stages();
    const auto scene = shared(std::move(data));
    return make_result(objects_of(*scene, options.pipeline, running.on_begin()), scene);
  });
}

/// Per pixel of a frame 0, or 1 + the object that it shows.
std::vector<std::uint16_t> labels_of(const SegmentationResult& result, const DepthFrame& frame,
                                     const CameraIntrinsics& camera,
                                     const LabelImageOptions& options) {
  if (result.cloud.empty()) return std::vector<std::uint16_t>(camera.pixels());
  std::vector<PointIndices> masks;
  for (const SceneObject& object : result.objects) masks.push_back(object.points);
  const PointsInView points(result.cloud, result.table, options);
  return label_image(points.points_of(camera, frame.depth, Eigen::Isometry3d::Identity()), masks,
                     result.cloud.size());
}

SceneData scene_data(ViewInput view, std::vector<StageTime> timings) {
  timings.insert(timings.end(), view.scene.stages.begin(), view.scene.stages.end());
  return {std::move(view.scene.built.scene),
          std::move(view.surface),
          std::move(view.cameras),
          std::nullopt,
          {},
          std::move(timings)};
}

ResultHandle segment_frame(DepthFrame frame, const CameraIntrinsics& camera,
                           const KnownTable& table, std::optional<Sensor> named,
                           const SegmentOptions& options, const StageTimer::OnBegin& on_begin) {
  StageTimer timer(on_begin);
  const SensorChoice sensor = timer.time("estimate sensor", [&] {
    constexpr bool tracked = false;
    return choose_sensor({&frame, 1}, tracked, camera, named, options.sensor);
  });
  on_begin("find table");
  ViewInput view = view_input(std::move(frame), camera, sensor, table, options.view);
  const DepthFrame prepared = std::move(view.frame);
  const auto scene = shared(scene_data(std::move(view), timer.stages()));
  SegmentationResult result = objects_of(*scene, options.pipeline, on_begin);
  LabelImageOptions labeling = options.masks;
  labeling.noise = sensor.noise.value_or(labeling.noise);
  std::vector<std::uint16_t> labels = labels_of(result, prepared, camera, labeling);
  return make_result(std::move(result), scene, std::move(labels), camera.width);
}

ResultHandle segment_depth(py::handle depth, py::handle intrinsics,
                           std::optional<double> depth_scale, py::handle color, py::handle table,
                           bool any_up, const std::optional<std::string>& sensor,
                           const std::string& json, const py::object& progress, int threads) {
  const SegmentOptions options = segment_options(json);
  DepthArray read = depth_from(depth, depth_scale, "depth");
  const CameraIntrinsics camera = intrinsics_from(intrinsics, read.width, read.height);
  DepthFrame frame{0.0, std::move(read.depth), {}};
  if (!color.is_none()) frame.colors = colors_from(color, "color");
  if (!color.is_none() && static_cast<std::size_t>(frame.colors.rows()) != camera.pixels())
    throw InputError("color", "as many pixels as the depth image", described(color));
  const KnownTable known = table_from(table, any_up);
  const std::optional<Sensor> named = named_sensor(sensor.value_or("auto"));
  const Running running(progress, threads);
  return running.without_gil([&] {
    return segment_frame(std::move(frame), camera, known, named, options, running.on_begin());
  });
}

}  // namespace

void bind_segmentation(py::module_& module) {
  module.def("segment_scene", &segment_known, py::arg("scene"), py::arg("options"),
             py::arg("progress"), py::arg("threads"));
  module.def("segment_cloud", &segment_cloud, py::arg("cloud"), py::arg("occupancy"),
             py::arg("table"), py::arg("any_up"), py::arg("options"), py::arg("progress"),
             py::arg("threads"));
  module.def("segment_depth", &segment_depth, py::arg("depth"), py::arg("intrinsics"),
             py::arg("depth_scale"), py::arg("color"), py::arg("table"), py::arg("any_up"),
             py::arg("sensor"), py::arg("options"), py::arg("progress"), py::arg("threads"));
}

}  // namespace symscene::python
