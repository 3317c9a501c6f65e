#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "handles.hpp"
#include "option_reading.hpp"
#include "running.hpp"
#include "symscene/symmetry/single_object.hpp"
#include "symscene/symmetry/symmetry_group.hpp"

namespace symscene::python {
namespace {

py::array_t<double> rotations_of(const SymmetryGroup& group) {
  Trajectory poses;
  for (const Eigen::Isometry3d& rotation : group.rotations) poses.push_back({0.0, rotation});
  return array_of(poses);
}

/// Of a mesh or of a cloud.
template <class Model>
SymmetryGroup of_whole(const Model& model, const std::string& json, int threads) {
  const auto options = options_from<SymmetryGroupOptions>(json);
  return Running(py::none(), threads).without_gil([&] {
    return find_symmetry_group(even_surface(model), options);
  });
}

SymmetryGroup of_mesh(const MeshHandle& mesh, const std::string& json, int threads) {
  return of_whole(*mesh.mesh, json, threads);
}

SymmetryGroup of_cloud(const CloudHandle& cloud, const std::string& json, int threads) {
  return of_whole(*cloud.cloud, json, threads);
}

ObjectSymmetries of_partial(const CloudHandle& cloud, const std::string& json, int threads) {
  const auto options = options_from<SingleObjectOptions>(json);
  return Running(py::none(), threads).without_gil([&] {
    return detect_object_symmetries(*cloud.cloud, options);
  });
}

void bind_elements(py::module_& module) {
  py::class_<GroupAxis>(module, "GroupAxis", "A rotational symmetry of a whole surface.")
      .def_property_readonly(
          "point", [](const GroupAxis& a) { return array_of(a.axis.point); }, "(3,) on it")
      .def_property_readonly(
          "direction", [](const GroupAxis& a) { return array_of(a.axis.direction); },
          "(3,) unit vector along it")
      .def_readonly("order", &GroupAxis::order,
                    "the surface repeats every 2 pi / order; 0: at every angle")
      .def_readonly("residual", &GroupAxis::residual,
                    "mean distance of the turned surface from the surface");
  py::class_<GroupPlane>(module, "GroupPlane", "A reflectional symmetry of a whole surface.")
      .def_property_readonly(
          "point", [](const GroupPlane& p) { return array_of(p.plane.point); }, "(3,) on it")
      .def_property_readonly(
          "normal", [](const GroupPlane& p) { return array_of(p.plane.normal); },
          "(3,) unit vector")
      .def_readonly("residual", &GroupPlane::residual,
                    "mean distance of the reflected surface from the surface");
}

void bind_group(py::module_& module) {
  py::class_<SymmetryGroup>(
      module, "SymmetryGroup",
      "The symmetry group of a whole surface, in the frame and unit of the surface.")
      .def_readonly("axes", &SymmetryGroup::axes,
                    "list of GroupAxis, a continuous axis first, then by descending order")
      .def_readonly("planes", &SymmetryGroup::planes,
                    "list of GroupPlane by ascending residual, without those that contain a "
                    "continuous axis")
      .def_property_readonly("rotations", &rotations_of,
                             "(N, 4, 4) proper rotations other than the identity")
      .def_property_readonly(
          "center", [](const SymmetryGroup& g) { return array_of(g.center); },
          "(3,) which all symmetries leave in place")
      .def_readonly("sphere", &SymmetryGroup::sphere,
                    "all lines and planes through the center are symmetries; none is listed")
      .def_readonly("diameter", &SymmetryGroup::diameter, "greatest distance of two points")
      .def_readonly("diagonal", &SymmetryGroup::diagonal, "of the narrowest box around it");
  py::class_<ObjectSymmetries>(
      module, "ObjectSymmetries",
      "The probable symmetries of a partial scan, in the frame and unit of its points.")
      .def_readonly("axes", &ObjectSymmetries::rotational, "list of at most one ObjectAxis")
      .def_readonly("planes", &ObjectSymmetries::reflectional,
                    "list of ObjectPlane, by ascending residual")
      .def_readonly("sphere", &ObjectSymmetries::sphere,
                    "all lines and planes through the centroid are symmetries; none is listed")
      .def_property_readonly(
          "centroid", [](const ObjectSymmetries& s) { return array_of(s.centroid); }, "(3,)");
}

}  // namespace

void bind_symmetries(py::module_& module) {
  bind_elements(module);
  bind_group(module);
  module.def("mesh_symmetries", &of_mesh, py::arg("mesh"), py::arg("options"), py::arg("threads"));
  module.def("cloud_symmetries", &of_cloud, py::arg("cloud"), py::arg("options"),
             py::arg("threads"));
  module.def("partial_symmetries", &of_partial, py::arg("cloud"), py::arg("options"),
             py::arg("threads"));
  module.def(
      "sampled_surface",
      [](const MeshHandle& mesh) { return CloudHandle{shared(even_surface(*mesh.mesh))}; },
      py::arg("mesh"), py::call_guard<py::gil_scoped_release>());
}

}  // namespace symscene::python
