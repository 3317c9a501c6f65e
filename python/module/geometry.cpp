#include <fmt/format.h>
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "symscene/core/camera.hpp"
#include "symscene/core/object_box.hpp"
#include "symscene/core/object_class.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/solid.hpp"

namespace symscene::python {
namespace {

void bind_camera(py::module_& module) {
  py::class_<CameraIntrinsics>(
      module, "CameraIntrinsics",
      "A pinhole camera that looks along +z, with +x to the right of the image and +y down. The\n"
      "centre of the first pixel is (0, 0). All values are in pixels.")
      .def(py::init<Index, Index, double, double, double, double>(), py::arg("width"),
           py::arg("height"), py::arg("fx"), py::arg("fy"), py::arg("cx"), py::arg("cy"))
      .def_readonly("width", &CameraIntrinsics::width)
      .def_readonly("height", &CameraIntrinsics::height)
      .def_readonly("fx", &CameraIntrinsics::fx)
      .def_readonly("fy", &CameraIntrinsics::fy)
      .def_readonly("cx", &CameraIntrinsics::cx)
      .def_readonly("cy", &CameraIntrinsics::cy)
      .def("__repr__", [](const CameraIntrinsics& c) {
        return fmt::format("CameraIntrinsics({}, {}, {}, {}, {}, {})", c.width, c.height, c.fx,
                           c.fy, c.cx, c.cy);
      });
}

void bind_symmetries_of_objects(py::module_& module) {
  py::class_<ObjectAxis>(module, "ObjectAxis",
                         "A rotational symmetry: every rotation about a line. World frame.")
      .def_property_readonly(
          "point", [](const ObjectAxis& a) { return array_of(a.axis.point); }, "(3,) on it [m]")
      .def_property_readonly(
          "direction", [](const ObjectAxis& a) { return array_of(a.axis.direction); },
          "(3,) unit vector along it")
      .def_readonly("residual", &ObjectAxis::residual, "0 for a perfect fit");
  py::class_<ObjectPlane>(module, "ObjectPlane",
                          "A reflectional symmetry: a mirror plane. World frame.")
      .def_property_readonly(
          "point", [](const ObjectPlane& p) { return array_of(p.plane.point); }, "(3,) on it [m]")
      .def_property_readonly(
          "normal", [](const ObjectPlane& p) { return array_of(p.plane.normal); },
          "(3,) unit vector")
      .def_readonly("residual", &ObjectPlane::residual, "0 for a perfect fit");
}

void bind_class(py::module_& module) {
  py::class_<Dimension>(module, "Dimension", "A length of an object.")
      .def_readonly("name", &Dimension::name, "length, width, height, radius or apothem")
      .def_readonly("value", &Dimension::value, "estimate; without sigma a lower bound [m]")
      .def_readonly("sigma", &Dimension::sigma, "standard deviation, or None [m]")
      .def_readonly("reason", &Dimension::reason, "why there is no sigma");
  py::class_<ObjectClass>(module, "ObjectClass",
                          "The symmetries that an object has together, and its dimensions.")
      .def_property_readonly(
          "name", [](const ObjectClass& c) { return to_string(c.kind); },
          "none, mirror, prism, box, n_fold, revolution, cylinder or sphere")
      .def_property_readonly(
          "center", [](const ObjectClass& c) { return array_of(c.center); },
          "(3,) on all planes and axes [m]")
      .def_property_readonly(
          "axes", [](const ObjectClass& c) { return array_of(c.axes); },
          "(3, 3) orthonormal columns: normals of the planes; the third is the axis, if any")
      .def_readonly("order", &ObjectClass::order, "of n_fold, otherwise 0")
      .def_readonly("residual", &ObjectClass::residual,
                    "root mean square distance of the explained points [m]")
      .def_readonly("explained", &ObjectClass::explained, "share of the points, in [0, 1]")
      .def_readonly("dimensions", &ObjectClass::dimensions)
      .def("__repr__", [](const ObjectClass& c) { return fmt::format("<{}>", to_string(c.kind)); });
}

void bind_box(py::module_& module) {
  py::class_<ObjectBox>(module, "ObjectBox",
                        "A frame that is fixed to an object, and the box around it.")
      .def_property_readonly(
          "T_world_object",
          [](const ObjectBox& b) { return array_of(b.T_world_object.transform()); }, "(4, 4) [m]")
      .def_property_readonly(
          "T_world_box", [](const ObjectBox& b) { return array_of(b.T_world_box.transform()); },
          "(4, 4): the same axes, the origin in the middle of the box [m]")
      .def_property_readonly(
          "size", [](const ObjectBox& b) { return array_of(b.size); },
          "(3,) edges along the three axes [m]");
  py::class_<SolidProperties>(module, "SolidProperties",
                              "A body of uniform density within a closed surface.")
      .def_readonly("volume", &SolidProperties::volume, "[m3]")
      .def_property_readonly(
          "centre_of_mass", [](const SolidProperties& s) { return array_of(s.centre_of_mass); },
          "(3,) [m]")
      .def_property_readonly(
          "principal_axes", [](const SolidProperties& s) { return array_of(s.principal_axes); },
          "(3, 3) unit vectors as columns, the longest direction first")
      .def_property_readonly(
          "principal_moments",
          [](const SolidProperties& s) { return array_of(s.principal_moments); },
          "(3,) moments of inertia about them, divided by the mass [m2]");
}

}  // namespace

void bind_geometry(py::module_& module) {
  bind_camera(module);
  bind_symmetries_of_objects(module);
  bind_class(module);
  bind_box(module);
}

}  // namespace symscene::python
