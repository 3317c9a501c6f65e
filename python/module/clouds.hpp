#pragma once

#include <string>

#include <pybind11/pybind11.h>

#include "symscene/core/point_cloud.hpp"

namespace symscene::python {

/// A cloud from arrays; normals and colours may be None. Throws InputError, which names `name` or
/// the argument, if an array is not valid or they are not as many.
PointCloud cloud_from(pybind11::handle points, pybind11::handle normals, pybind11::handle colors,
                      const std::string& name);

}  // namespace symscene::python
