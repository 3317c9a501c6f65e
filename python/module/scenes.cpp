#include "scenes.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "clouds.hpp"
#include "handles.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/mesh.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/io/table_plane.hpp"
#include "symscene/io/trajectory.hpp"

namespace symscene::python {
namespace {

namespace fs = std::filesystem;

SceneHandle scene_from(py::handle points, py::handle normals, py::handle colors,
                       const OccupancyHandle* occupancy, py::handle table) {
  Scene scene;
  scene.cloud = cloud_from(points, normals, colors, "points");
  if (occupancy != nullptr) scene.occupancy = *occupancy->map;
  if (!table.is_none()) scene.table = plane_from(table, "table");
  return {shared(SceneData{std::move(scene)})};
}

/// Reads what is for display only. An invalid file gives a warning, as from the command.
template <class Value, class Read>
void read_beside(const fs::path& file, Value& value, std::vector<std::string>& warnings,
                 const Read& read) {
  if (!fs::exists(file)) return;
  try {
    value = read(file);
  } catch (const InputError& error) {
    warnings.push_back(fmt::format("{}; it is left out", error.what()));
  }
}

SceneHandle read(const fs::path& folder) {
  const py::gil_scoped_release released;
  SceneData data{read_scene(folder)};
  read_beside(folder / "mesh.ply", data.surface, data.scene.warnings, read_mesh);
  read_beside(folder / "poses.txt", data.cameras, data.scene.warnings, read_trajectory);
  return {shared(std::move(data))};
}

void write(const fs::path& folder, const SceneHandle& handle) {
  const py::gil_scoped_release released;
  const SceneData& data = *handle.data;
  SceneExtras extras;
  if (data.surface.vertices.rows() != 0) extras.mesh = &data.surface;
  if (!data.cameras.empty()) extras.trajectory = &data.cameras;
  if (data.camera) extras.camera = &*data.camera;
  if (!data.log_odds.leaves.empty()) extras.log_odds = &data.log_odds;
  write_scene(fs::absolute(folder), data.scene, extras);
}

}  // namespace

Plane plane_from(py::handle value, const std::string& name) {
  const std::vector<double> n = numbers_from(value, 4, name);
  return parse_table_plane(fmt::format("{} {} {} {}", n[0], n[1], n[2], n[3]), name);
}

KnownTable table_from(py::handle value, bool any_up) {
  KnownTable known;
  known.any_up = any_up;
  if (value.is_none()) return known;
  if (any_up) throw InputError("any_up", "no table beside it", "both");
  if (py::isinstance<py::bool_>(value)) {
    if (value.cast<bool>())
      throw InputError("table", "None, False (there is no table), or a, b, c, d", "True");
    known.absent = true;
  } else {
    known.plane = plane_from(value, "table");
  }
  return known;
}

void bind_scenes(py::module_& module) {
  py::class_<SceneHandle>(
      module, "Scene",
      "The cloud of the objects on a table, with the table's plane and the occupancy of the space\n"
      "around them, where they are known. World frame, metres.")
      .def(py::init(&scene_from), py::arg("points"), py::arg("normals") = py::none(),
           py::arg("colors") = py::none(), py::arg("occupancy") = py::none(),
           py::arg("table") = py::none())
      .def_property_readonly(
          "cloud",
          [](const SceneHandle& s) { return CloudHandle{part_of(s.data, s.data->scene.cloud)}; })
      .def_property_readonly(
          "occupancy",
          [](const SceneHandle& s) -> std::optional<OccupancyHandle> {
            if (!s.data->scene.occupancy) return {};
            return OccupancyHandle{part_of(s.data, *s.data->scene.occupancy)};
          },
          "Occupancy, or None")
      .def_property_readonly(
          "table", [](const SceneHandle& s) { return array_or_none(s.data->scene.table); },
          "(4,) a, b, c, d with ax + by + cz + d = 0 and the unit normal (a, b, c) up [m], or None")
      .def_property_readonly(
          "mesh",
          [](const SceneHandle& s) -> std::optional<MeshHandle> {
            if (s.data->surface.vertices.rows() == 0) return {};
            return MeshHandle{part_of(s.data, s.data->surface)};
          },
          "TriangleMesh of the whole surface, or None")
      .def_property_readonly(
          "T_world_cameras", [](const SceneHandle& s) { return array_of(s.data->cameras); },
          "(N, 4, 4) poses of the fused frames [m]")
      .def_property_readonly(
          "timings", [](const SceneHandle& s) { return list_of(s.data->timings); },
          "list of (stage, seconds)")
      .def_property_readonly(
          "warnings", [](const SceneHandle& s) { return s.data->scene.warnings; },
          "list of sentences")
      .def("__repr__", [](const SceneHandle& s) {
        return fmt::format("<Scene of {} points>", s.data->scene.cloud.size());
      });
  module.def("read_scene", &read, py::arg("path"));
  module.def("write_scene", &write, py::arg("path"), py::arg("scene"));
}

}  // namespace symscene::python
