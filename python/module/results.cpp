#include <filesystem>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "handles.hpp"
#include "symscene/io/result.hpp"

namespace symscene::python {
namespace {

namespace fs = std::filesystem;

py::object label_image_of(const ResultHandle& handle) {
  const ResultData& data = *handle.data;
  if (data.width == 0) return py::none();
  const auto width = static_cast<py::ssize_t>(data.width);
  const auto height = static_cast<py::ssize_t>(data.labels.size()) / width;
  return view(handle.data, data.labels.data(), {height, width}, {width, 1});
}

std::vector<ObjectHandle> objects_of(const ResultHandle& handle) {
  std::vector<ObjectHandle> objects;
  for (std::size_t id = 0; id < handle.data->result.objects.size(); ++id)
    objects.push_back({handle.data, id});
  return objects;
}

py::list steps_of(const std::vector<FunnelStep>& funnel) {
  py::list pairs;
  for (const FunnelStep& step : funnel) pairs.append(py::make_tuple(step.step, step.count));
  return pairs;
}

void write(const fs::path& folder, const ResultHandle& handle) {
  const py::gil_scoped_release released;
  const ResultData& data = *handle.data;
  ResultExtras extras;
  if (data.scene && !data.scene->cameras.empty()) extras.trajectory = &data.scene->cameras;
  write_result(fs::absolute(folder), data.result, extras);
}

ResultHandle read(const fs::path& folder) {
  const py::gil_scoped_release released;
  SegmentationResult result = read_result(folder);
  Surroundings around = read_result_surroundings(folder);
  SceneData surroundings;
  surroundings.surface = std::move(around.surface);
  surroundings.cameras = std::move(around.trajectory);
  return make_result(std::move(result), shared(std::move(surroundings)));
}

void bind_rejection(py::module_& module) {
  py::class_<Rejection>(module, "Rejection", "A hypothesis that did not become an object.")
      .def_readonly("kind", &Rejection::kind, "rotational, reflectional or surface")
      .def_readonly("reason", &Rejection::reason, "the bound that failed")
      .def_readonly("value", &Rejection::value, "what was compared with the bound")
      .def_readonly("bound", &Rejection::bound)
      .def_readonly("size", &Rejection::size, "points of the hypothesis");
}

using ObjectType = py::class_<ObjectHandle>;

/// The points of an object.
void bind_mask(ObjectType& type) {
  type.def_readonly("id", &ObjectHandle::id, "its place in the result")
      .def_property_readonly(
          "indices", [](const ObjectHandle& o) { return view(o.data, o.object().points); },
          "(N,) uint32, ascending: the object's mask, as rows of the result's points")
      .def_property_readonly(
          "points",
          [](const ObjectHandle& o) { return view(o.data, o.data->observed[o.id].positions); },
          "(N, 3) float32, the observed points [m]")
      .def_property_readonly(
          "normals",
          [](const ObjectHandle& o) { return view(o.data, o.data->observed[o.id].normals); },
          "(N, 3) float32 unit vectors out of the surface")
      .def_property_readonly(
          "colors",
          [](const ObjectHandle& o) { return view(o.data, o.data->observed[o.id].colors); },
          "(N, 3) uint8, or (0, 3)");
}

/// What is told about an object.
void bind_findings(ObjectType& type) {
  type.def_property_readonly(
          "score", [](const ObjectHandle& o) { return o.object().score; },
          "probability of being one whole object, or None")
      .def_property_readonly(
          "confidence", [](const ObjectHandle& o) { return o.object().confidence; },
          "of its best hypothesis, in [0, 1]; 0 for none")
      .def_property_readonly(
          "axes", [](const ObjectHandle& o) { return o.object().rotational; },
          "list of ObjectAxis, by ascending residual")
      .def_property_readonly(
          "planes", [](const ObjectHandle& o) { return o.object().reflectional; },
          "list of ObjectPlane, by ascending residual")
      .def_property_readonly(
          "symmetry_class", [](const ObjectHandle& o) { return o.object().symmetry_class; },
          "ObjectClass, or None")
      .def_property_readonly(
          "centroid", [](const ObjectHandle& o) { return array_or_none(o.object().centroid); },
          "(3,) centre of mass under the symmetries [m], or None")
      .def_property_readonly(
          "box", [](const ObjectHandle& o) { return o.object().box; }, "ObjectBox, or None")
      .def_property_readonly(
          "solid", [](const ObjectHandle& o) { return o.object().solid; },
          "SolidProperties of the closed surface, or None");
}

/// The hidden side of an object.
void bind_hidden_side(ObjectType& type) {
  type.def_property_readonly(
          "completed",
          [](const ObjectHandle& o) {
            return CloudHandle{part_of(o.data, o.data->result.completed[o.id])};
          },
          "PointCloud of what the symmetries add on the hidden side")
      .def_property_readonly(
          "mesh",
          [](const ObjectHandle& o) -> std::optional<MeshHandle> {
            const TriangleMesh& mesh = o.data->result.surfaces[o.id].mesh;
            if (mesh.triangles.rows() == 0) return {};
            return MeshHandle{part_of(o.data, mesh)};
          },
          "TriangleMesh, the closed surface with its hidden side, or None")
      .def_property_readonly(
          "observed_triangles",
          [](const ObjectHandle& o) {
            return view(o.data, o.data->result.surfaces[o.id].observed);
          },
          "(T,) uint8 per triangle of the mesh: 1 observed, 0 inferred");
}

void bind_object(py::module_& module) {
  ObjectType type(
      module, "SceneObject",
      "An object of a result. Arrays are read-only views and keep the result's memory alive.");
  bind_mask(type);
  bind_findings(type);
  bind_hidden_side(type);
  type.def("__repr__", [](const ObjectHandle& o) {
    const auto& kind = o.object().symmetry_class;
    return fmt::format("<SceneObject {}: {} points, score {:.2f}, {}>", o.id,
                       o.object().points.size(), o.object().rank(),
                       kind ? to_string(kind->kind) : "no class");
  });
}

void bind_result(py::module_& module) {
  py::class_<ResultHandle>(
      module, "SegmentationResult",
      "The objects of a scene, best first. Arrays are read-only views. World frame (of a depth\n"
      "image: the camera's frame), metres.")
      .def_property_readonly("objects", &objects_of, "list of SceneObject, by descending score")
      .def_property_readonly(
          "cloud",
          [](const ResultHandle& r) { return CloudHandle{part_of(r.data, r.data->result.cloud)}; },
          "PointCloud that all indices refer to, by default one point per 5 mm")
      .def_property_readonly(
          "points",
          [](const ResultHandle& r) { return view(r.data, r.data->result.cloud.positions); },
          "(N, 3) float32, those of the cloud [m]")
      .def_property_readonly("label_image", &label_image_of,
                             "(height, width) uint16 of a depth image: 0, or 1 + the object's id; "
                             "otherwise None")
      .def_property_readonly(
          "table", [](const ResultHandle& r) { return array_or_none(r.data->result.table); },
          "(4,) a, b, c, d with ax + by + cz + d = 0 and the unit normal (a, b, c) up [m], or None")
      .def_property_readonly(
          "scene",
          [](const ResultHandle& r) -> std::optional<SceneHandle> {
            if (!r.data->scene || r.data->scene->scene.cloud.empty()) return {};
            return SceneHandle{r.data->scene};
          },
          "Scene that was segmented, or None of a result that was read")
      .def_property_readonly(
          "rejected", [](const ResultHandle& r) { return r.data->result.rejected; },
          "list of Rejection")
      .def_property_readonly(
          "funnel", [](const ResultHandle& r) { return steps_of(r.data->result.funnel); },
          "list of (step, candidates that remain)")
      .def_property_readonly(
          "timings", [](const ResultHandle& r) { return list_of(r.data->result.timings); },
          "list of (stage, seconds)")
      .def_property_readonly(
          "warnings", [](const ResultHandle& r) { return r.data->result.warnings; },
          "list of sentences: limitations of the result")
      .def("__repr__", [](const ResultHandle& r) {
        return fmt::format("<SegmentationResult of {} objects>", r.data->result.objects.size());
      });
  module.def("read_result", &read, py::arg("path"));
  module.def("write_result", &write, py::arg("path"), py::arg("result"));
}

}  // namespace

ResultHandle make_result(SegmentationResult result, std::shared_ptr<const SceneData> scene,
                         std::vector<std::uint16_t> labels, Index width) {
  ResultData data{std::move(result), std::move(scene), {}, std::move(labels), width};
  for (const SceneObject& object : data.result.objects)
    data.observed.push_back(select(data.result.cloud, object.points));
  data.result.completed.resize(data.result.objects.size());
  data.result.surfaces.resize(data.result.objects.size());
  return {shared(std::move(data))};
}

void bind_results(py::module_& module) {
  bind_rejection(module);
  bind_object(module);
  bind_result(module);
}

}  // namespace symscene::python
