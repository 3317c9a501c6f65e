#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "camera_reading.hpp"
#include "frames.hpp"
#include "handles.hpp"
#include "option_reading.hpp"
#include "running.hpp"
#include "scenes.hpp"
#include "symscene/workflow/tracked_scene.hpp"

namespace symscene::python {
namespace {

PoseUse pose_use_of(const std::string& name) {
  if (name == "exact") return PoseUse::exact;
  if (name == "start") return PoseUse::start;
  if (name == "prior") return PoseUse::prior;
  throw InputError("pose_use", "\"exact\", \"start\" or \"prior\"", "\"" + name + "\"");
}

/// A reconstruction that threads of Python may share.
class SharedReconstruction {
  template <class Work>
  auto locked(const Work& work) {
    return running_.without_gil([&] {
      const std::scoped_lock lock(mutex_);
      return work();
    });
  }

 public:
  SharedReconstruction(py::object intrinsics, const std::optional<std::string>& sensor,
                       const std::string& json, int threads)
      : intrinsics_(std::move(intrinsics)),
        options_(options_from<TrackedSceneOptions>(json)),
        sensor_(named_sensor(sensor.value_or("auto"))),
        running_(py::none(), threads) {}

  void look_at(const std::vector<FrameHandle>& frames, bool is_tracked) {
    if (frames.empty()) return;
    open(*frames.front().data);
    std::vector<DepthFrame> copies;
    for (const FrameHandle& frame : frames) copies.push_back(frame.data->frame);
    locked([&] { tracked_->look_at(copies, is_tracked); });
  }

  FrameReport add(const FrameHandle& frame, const std::string& use) {
    const PoseUse pose_use = pose_use_of(use);
    open(*frame.data);
    return locked(
        [&] { return tracked_->add(frame.data->frame, frame.data->T_world_camera, pose_use); });
  }

  MeshHandle surface() {
    return locked(
        [&] { return MeshHandle{shared(tracked_ ? tracked_->surface() : TriangleMesh{})}; });
  }

  py::array_t<double> cameras() {
    return array_of(locked([&] { return tracked_ ? tracked_->cameras() : Trajectory{}; }));
  }

  SceneHandle scene(py::handle table, bool any_up) {
    const KnownTable known = table_from(table, any_up);
    if (!tracked_) throw InputError("frames", "a frame that can be fused", "none was added");
    return locked([&] {
      SweepScene made = tracked_->scene(known);
      SceneData data{std::move(made.built.scene)};
      data.surface = std::move(made.surface);
      data.cameras = std::move(made.cameras);
      data.camera = tracked_->camera();
      data.log_odds = std::move(made.log_odds);
      return SceneHandle{shared(std::move(data))};
    });
  }

 private:
  /// Starts with the size of the first frame.
  void open(const FrameData& frame) {
    const CameraIntrinsics camera = intrinsics_from(intrinsics_, frame.width, frame.height);
    if (!tracked_) tracked_.emplace(camera, options_, sensor_);
  }

  py::object intrinsics_;
  TrackedSceneOptions options_;
  std::optional<Sensor> sensor_;
  Running running_;
  std::mutex mutex_;
  std::optional<TrackedScene> tracked_;
};

void bind_report(py::module_& module) {
  py::class_<FrameReport>(module, "FrameReport", "What became of a frame.")
      .def_property_readonly(
          "status", [](const FrameReport& r) { return to_string(r.tracking.status); },
          "converged, degenerate (some motions are not constrained) or lost")
      .def_property_readonly(
          "T_world_camera",
          [](const FrameReport& r) { return array_of(r.tracking.T_world_camera); },
          "(4, 4), unless the frame is lost [m]")
      .def_readonly("fused", &FrameReport::fused, "the frame is part of the model")
      .def_readonly("relocalized", &FrameReport::relocalized,
                    "the camera was lost and has been found")
      .def_property_readonly(
          "unconstrained", [](const FrameReport& r) { return r.tracking.unconstrained; },
          "list of the motions that are free, if degenerate")
      .def_property_readonly(
          "reason", [](const FrameReport& r) { return r.tracking.reason; },
          "why the camera is lost")
      .def_property_readonly(
          "residual", [](const FrameReport& r) { return r.tracking.residual; },
          "root mean square residual of the inliers [m]")
      .def("__repr__", [](const FrameReport& r) {
        return fmt::format("<FrameReport: {}>", to_string(r.tracking.status));
      });
}

}  // namespace

void bind_reconstruction(py::module_& module) {
  bind_report(module);
  py::class_<SharedReconstruction>(module, "TrackedScene")
      .def(py::init<py::object, const std::optional<std::string>&, const std::string&, int>(),
           py::arg("intrinsics"), py::arg("sensor"), py::arg("options"), py::arg("threads"))
      .def("look_at", &SharedReconstruction::look_at, py::arg("frames"), py::arg("is_tracked"))
      .def("add", &SharedReconstruction::add, py::arg("frame"), py::arg("pose_use"))
      .def("surface", &SharedReconstruction::surface)
      .def("scene", &SharedReconstruction::scene, py::arg("table"), py::arg("any_up"))
      .def_property_readonly("T_world_cameras", &SharedReconstruction::cameras);
}

}  // namespace symscene::python
