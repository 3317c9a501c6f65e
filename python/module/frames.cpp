#include "frames.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "camera_reading.hpp"
#include "handles.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/camera_file.hpp"
#include "symscene/io/intrinsics.hpp"
#include "symscene/io/sequence.hpp"
#include "symscene/workflow/sensor_choice.hpp"

namespace symscene::python {
namespace {

namespace fs = std::filesystem;

struct SequenceHandle {
  std::shared_ptr<const DepthSequence> sequence;
};

py::array depth_view(const FrameHandle& f) {
  const auto width = static_cast<py::ssize_t>(f.data->width);
  return view(f.data, f.data->frame.depth.data(), {static_cast<py::ssize_t>(f.data->height), width},
              {width, 1});
}

py::object color_view(const FrameHandle& f) {
  const Colors& colors = f.data->frame.colors;
  if (colors.rows() == 0) return py::none();
  const auto width = static_cast<py::ssize_t>(f.data->width);
  return view(f.data, colors.data(), {static_cast<py::ssize_t>(f.data->height), width, 3},
              {3 * width, 3, 1});
}

void bind_frame(py::module_& module) {
  py::class_<FrameHandle>(
      module, "Frame", "A depth image with optional colours and pose. Arrays are read-only views.")
      .def(py::init(&frame_from), py::arg("depth"), py::arg("color") = py::none(),
           py::arg("T_world_camera") = py::none(), py::arg("time") = 0.0,
           py::arg("depth_scale") = py::none())
      .def_property_readonly("depth", &depth_view,
                             "(height, width) float32, 0 where nothing was measured [m]")
      .def_property_readonly("color", &color_view, "(height, width, 3) uint8, or None")
      .def_property_readonly(
          "time", [](const FrameHandle& f) { return f.data->frame.time; }, "[s]")
      .def_property_readonly(
          "T_world_camera",
          [](const FrameHandle& f) { return array_or_none(f.data->T_world_camera); },
          "(4, 4) [m], or None");
}

/// Intrinsics of a sequence as --intrinsics takes them: a file, or values for images of any size.
void set_camera(py::handle intrinsics, SequenceOptions& options) {
  if (intrinsics.is_none()) return;
  if (py::isinstance<CameraIntrinsics>(intrinsics)) {
    options.intrinsics = intrinsics.cast<CameraIntrinsics>();
  } else if (py::isinstance<py::str>(intrinsics) || py::hasattr(intrinsics, "__fspath__")) {
    const auto path = intrinsics.cast<fs::path>();
    if (is_camera_file(path))
      options.camera = read_camera_model(path);
    else
      options.intrinsics = read_intrinsics(path);
  } else {
    const std::vector<double> k = numbers_from(intrinsics, 4, "intrinsics");
    options.intrinsics = CameraIntrinsics{0, 0, k[0], k[1], k[2], k[3]};
  }
}

SequenceHandle open(const fs::path& path, py::handle intrinsics,
                    std::optional<double> depth_scale) {
  SequenceOptions options;
  options.depth_scale = depth_scale;
  set_camera(intrinsics, options);
  const py::gil_scoped_release released;
  return {open_sequence(path, options)};
}

FrameHandle frame_of(const DepthSequence& sequence, DepthFrame frame,
                     std::optional<Eigen::Isometry3d> pose) {
  const CameraIntrinsics& camera = sequence.camera();
  return {shared(FrameData{std::move(frame), camera.width, camera.height, std::move(pose)})};
}

FrameHandle read(const SequenceHandle& handle, py::ssize_t index) {
  const DepthSequence& sequence = *handle.sequence;
  const auto size = static_cast<py::ssize_t>(sequence.size());
  const py::ssize_t place = index < 0 ? index + size : index;
  if (place < 0 || place >= size) throw py::index_error("no such frame");
  const py::gil_scoped_release released;
  const auto i = static_cast<std::size_t>(place);
  return frame_of(sequence, sequence.read(i), sequence.pose(i));
}

std::vector<FrameHandle> spread(const SequenceHandle& handle, int count) {
  const py::gil_scoped_release released;
  std::vector<FrameHandle> frames;
  for (DepthFrame& frame : some_frames(*handle.sequence, count).frames)
    frames.push_back(frame_of(*handle.sequence, std::move(frame), {}));
  return frames;
}

void bind_sequence(py::module_& module) {
  py::class_<SequenceHandle>(
      module, "DepthSequence",
      "Depth images on disk, read when they are asked for: sequence[i], len(sequence), or a loop.")
      .def("__len__", [](const SequenceHandle& s) { return s.sequence->size(); })
      .def("__getitem__", &read, py::arg("index"))
      .def("__iter__",
           [](const py::object& self) {
             return py::reinterpret_steal<py::object>(PySeqIter_New(self.ptr()));
           })
      .def("spread_frames", &spread, py::arg("count"),
           "At most count frames that are spread over the sequence.")
      .def_property_readonly(
          "camera", [](const SequenceHandle& s) { return s.sequence->camera(); },
          "CameraIntrinsics of the frames as they are read")
      .def_property_readonly(
          "layout", [](const SequenceHandle& s) { return s.sequence->layout(); },
          "name of the layout on disk")
      .def_property_readonly(
          "warnings", [](const SequenceHandle& s) { return s.sequence->warnings(); },
          "list of sentences");
  module.def(
      "open_sequence", &open, py::arg("path"), py::arg("intrinsics") = py::none(),
      py::arg("depth_scale") = py::none(),
      "Open a sequence of depth images: a folder in the layout of SymScene, TUM RGB-D,\n"
      "ICL-NUIM, 7-Scenes or Redwood, a recording of ROS, an image or a folder of images.\n\n"
      "intrinsics: CameraIntrinsics, (fx, fy, cx, cy) in pixels, or the path of a file like\n"
      "intrinsics.txt or camera.yaml, where the sequence has none. depth_scale: value of the\n"
      "images that is 1 m.");
}

void bind_writer(py::module_& module) {
  py::class_<SequenceWriter>(
      module, "SequenceWriter",
      "Writes a sequence folder frame by frame. It appears when finish() is called.")
      .def(py::init([](const fs::path& path, const CameraIntrinsics& camera) {
             return std::make_unique<SequenceWriter>(fs::absolute(path), camera);
           }),
           py::arg("path"), py::arg("camera"))
      .def(
          "add",
          [](SequenceWriter& writer, const FrameHandle& f) {
            const auto& pose = f.data->T_world_camera;
            writer.add(f.data->frame, pose ? &*pose : nullptr);
          },
          py::arg("frame"), "Adds a frame. Either all frames have a pose or none has.")
      .def("finish", &SequenceWriter::finish);
}

}  // namespace

FrameHandle frame_from(py::handle depth, py::handle color, py::handle pose, double time,
                       std::optional<double> depth_scale) {
  DepthArray read = depth_from(depth, depth_scale, "depth");
  FrameData data{{time, std::move(read.depth), {}}, read.width, read.height, {}};
  if (!color.is_none()) {
    data.frame.colors = colors_from(color, "color");
    if (static_cast<std::size_t>(data.frame.colors.rows()) != data.frame.depth.size())
      throw InputError("color", "as many pixels as the depth image", described(color));
  }
  if (!pose.is_none()) data.T_world_camera = pose_from(pose, "T_world_camera");
  return {shared(std::move(data))};
}

void bind_sequences(py::module_& module) {
  bind_frame(module);
  bind_sequence(module);
  bind_writer(module);
}

}  // namespace symscene::python
