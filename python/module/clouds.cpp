#include <filesystem>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "clouds.hpp"
#include "handles.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/cloud.hpp"
#include "symscene/io/mesh.hpp"
#include "symscene/io/octomap.hpp"

namespace symscene::python {
namespace {

namespace fs = std::filesystem;

void require_as_many(py::ssize_t rows, py::ssize_t expected, const char* name) {
  if (rows == 0 || rows == expected) return;
  throw InputError(name, fmt::format("as many rows as there are points, {}", expected),
                   fmt::format("{}", rows));
}

TriangleMesh mesh_from(py::handle vertices, py::handle triangles, py::handle normals,
                       py::handle colors) {
  const PointCloud cloud = cloud_from(vertices, normals, colors, "vertices");
  TriangleMesh mesh{cloud.positions, {}, cloud.colors, cloud.normals};
  constexpr const char* expected = "an array of indices of shape (T, 3)";
  const py::array array = py::array::ensure(triangles);
  if (!array) PyErr_Clear();
  const bool is_list = array && array.ndim() == 2 && array.shape(1) == 3 &&
                       (array.dtype().kind() == 'i' || array.dtype().kind() == 'u');
  if (!is_list) throw InputError("triangles", expected, described(triangles));
  const py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> indices(array);
  const auto values = indices.unchecked<2>();
  mesh.triangles.resize(values.shape(0), 3);
  for (py::ssize_t i = 0; i < values.shape(0); ++i) {
    for (py::ssize_t j = 0; j < 3; ++j) {
      if (values(i, j) < 0 || values(i, j) >= mesh.vertices.rows())
        throw InputError("triangles", fmt::format("indices below {}", mesh.vertices.rows()),
                         fmt::format("{}", values(i, j)));
      mesh.triangles(i, j) = static_cast<Index>(values(i, j));
    }
  }
  return mesh;
}

void bind_cloud(py::module_& module) {
  py::class_<CloudHandle>(
      module, "PointCloud",
      "Points with optional unit normals and colours. Arrays are read-only views of N rows.")
      .def(py::init(
               [](py::handle points, py::handle normals, py::handle colors, py::handle viewpoint) {
                 CloudHandle handle{shared(cloud_from(points, normals, colors, "points"))};
                 if (!viewpoint.is_none()) handle.viewpoint = vector_from(viewpoint, "viewpoint");
                 return handle;
               }),
           py::arg("points"), py::arg("normals") = py::none(), py::arg("colors") = py::none(),
           py::arg("viewpoint") = py::none())
      .def_property_readonly(
          "points", [](const CloudHandle& c) { return view(c.cloud, c.cloud->positions); },
          "(N, 3) float32 [m]")
      .def_property_readonly(
          "normals", [](const CloudHandle& c) { return view(c.cloud, c.cloud->normals); },
          "(N, 3) float32 unit vectors out of the surface, or (0, 3)")
      .def_property_readonly(
          "colors", [](const CloudHandle& c) { return view(c.cloud, c.cloud->colors); },
          "(N, 3) uint8 red, green and blue, or (0, 3)")
      .def_property_readonly(
          "viewpoint", [](const CloudHandle& c) { return array_of(c.viewpoint); },
          "(3,) position of the sensor; the origin where it is not known [m]")
      .def("__len__", [](const CloudHandle& c) { return c.cloud->size(); })
      .def("__repr__", [](const CloudHandle& c) {
        return fmt::format("<PointCloud of {} points>", c.cloud->size());
      });
  module.def(
      "read_cloud",
      [](const fs::path& path) {
        SensorCloud read = read_sensor_cloud(path);
        return CloudHandle{shared(std::move(read.cloud)), read.viewpoint};
      },
      py::arg("path"), py::call_guard<py::gil_scoped_release>());
  module.def(
      "write_cloud",
      [](const fs::path& path, const CloudHandle& cloud) { write_cloud(path, *cloud.cloud); },
      py::arg("path"), py::arg("cloud"), py::call_guard<py::gil_scoped_release>());
}

void bind_mesh(py::module_& module) {
  py::class_<MeshHandle>(module, "TriangleMesh", "A triangle mesh. Arrays are read-only views.")
      .def(py::init([](py::handle vertices, py::handle triangles, py::handle normals,
                       py::handle colors) {
             return MeshHandle{shared(mesh_from(vertices, triangles, normals, colors))};
           }),
           py::arg("vertices"), py::arg("triangles"), py::arg("normals") = py::none(),
           py::arg("colors") = py::none())
      .def_property_readonly(
          "vertices", [](const MeshHandle& m) { return view(m.mesh, m.mesh->vertices); },
          "(V, 3) float32 [m]")
      .def_property_readonly(
          "triangles", [](const MeshHandle& m) { return view(m.mesh, m.mesh->triangles); },
          "(T, 3) uint32 indices, counter-clockwise from outside")
      .def_property_readonly(
          "normals", [](const MeshHandle& m) { return view(m.mesh, m.mesh->normals); },
          "(V, 3) float32 unit vectors, or (0, 3)")
      .def_property_readonly(
          "colors", [](const MeshHandle& m) { return view(m.mesh, m.mesh->colors); },
          "(V, 3) uint8, or (0, 3)")
      .def("__repr__", [](const MeshHandle& m) {
        return fmt::format("<TriangleMesh of {} vertices and {} triangles>",
                           m.mesh->vertices.rows(), m.mesh->triangles.rows());
      });
  module.def(
      "read_mesh", [](const fs::path& path) { return MeshHandle{shared(read_mesh(path))}; },
      py::arg("path"), py::call_guard<py::gil_scoped_release>());
  module.def(
      "write_mesh",
      [](const fs::path& path, const MeshHandle& mesh) { write_mesh(path, *mesh.mesh); },
      py::arg("path"), py::arg("mesh"), py::call_guard<py::gil_scoped_release>());
}

/// The occupancy of a block of voxels: state (x, y, z) is that of the cube that begins at
/// origin + (x, y, z) resolution.
OccupancyMap occupancy_from(py::handle states, double resolution, py::handle origin) {
  constexpr const char* expected =
      "an array of uint8 of shape (X, Y, Z): 0 never seen, 1 free, 2 occupied";
  const py::array array = py::array::ensure(states);
  if (!array) PyErr_Clear();
  if (!array || array.ndim() != 3 || !array.dtype().is(py::dtype::of<std::uint8_t>()))
    throw InputError("states", expected, described(states));
  if (!(resolution > 0.0) || !std::isfinite(resolution))
    throw InputError("resolution", "a number above 0 m", fmt::format("{}", resolution));
  const Eigen::Vector3d low = vector_from(origin, "origin") / resolution;
  const Eigen::Array3d whole = low.array().round();
  const auto values = array.unchecked<std::uint8_t, 3>();
  VoxelBlock block{whole.matrix().cast<int>(), {}, {}};
  for (int k = 0; k < 3; ++k) block.size[k] = static_cast<int>(values.shape(k));
  const bool is_on_grid = (low.array() - whole).abs().maxCoeff() < 1e-3;
  const bool fits =
      whole.minCoeff() >= -OccupancyMap::key_of_origin &&
      (whole + block.size.array().cast<double>()).maxCoeff() <= OccupancyMap::key_of_origin;
  if (!is_on_grid || !fits)
    throw InputError("origin", "whole multiples of the resolution, within 32768 voxels of 0",
                     fmt::format("{} {} {} voxels", low.x(), low.y(), low.z()));
  block.states.reserve(static_cast<std::size_t>(array.size()));
  for (py::ssize_t z = 0; z < values.shape(2); ++z) {
    for (py::ssize_t y = 0; y < values.shape(1); ++y) {
      for (py::ssize_t x = 0; x < values.shape(0); ++x) {
        if (values(x, y, z) > 2)
          throw InputError("states", expected, fmt::format("{}", values(x, y, z)));
        block.states.push_back(static_cast<VoxelState>(values(x, y, z)));
      }
    }
  }
  return to_octree(block, resolution);
}

void bind_occupancy(py::module_& module) {
  py::class_<OccupancyHandle>(
      module, "Occupancy",
      "Free, occupied and never-seen space as an octree. Occupancy(states, resolution, origin)\n"
      "takes voxels of shape (X, Y, Z), 0 never seen, 1 free, 2 occupied; voxel (0, 0, 0) begins\n"
      "at the origin, whole multiples of the resolution [m].")
      .def(py::init([](py::handle states, double resolution, py::handle origin) {
             return OccupancyHandle{shared(occupancy_from(states, resolution, origin))};
           }),
           py::arg("states"), py::arg("resolution"), py::arg("origin"))
      .def_property_readonly(
          "resolution", [](const OccupancyHandle& o) { return o.map->resolution; },
          "edge of a voxel [m]")
      .def_property_readonly(
          "leaves", [](const OccupancyHandle& o) { return o.map->leaves.size(); },
          "number of free and occupied cubes");
  module.def(
      "read_occupancy",
      [](const fs::path& path) { return OccupancyHandle{shared(read_octomap(path))}; },
      py::arg("path"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace

PointCloud cloud_from(py::handle points, py::handle normals, py::handle colors,
                      const std::string& name) {
  PointCloud cloud;
  cloud.positions = points_from(points, name);
  if (!normals.is_none()) cloud.normals = points_from(normals, "normals");
  if (!colors.is_none()) cloud.colors = colors_from(colors, "colors");
  require_as_many(cloud.normals.rows(), cloud.positions.rows(), "normals");
  require_as_many(cloud.colors.rows(), cloud.positions.rows(), "colors");
  return cloud;
}

void bind_clouds(py::module_& module) {
  bind_cloud(module);
  bind_mesh(module);
  bind_occupancy(module);
}

}  // namespace symscene::python
