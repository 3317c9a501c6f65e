#pragma once

#include <pybind11/pybind11.h>

namespace symscene::python {

// Each adds the types and functions of one file, in this order: signatures name earlier types.

void bind_geometry(pybind11::module_& module);
void bind_clouds(pybind11::module_& module);
void bind_scenes(pybind11::module_& module);
void bind_results(pybind11::module_& module);
void bind_options(pybind11::module_& module);
void bind_segmentation(pybind11::module_& module);
void bind_symmetries(pybind11::module_& module);
void bind_sequences(pybind11::module_& module);
void bind_reconstruction(pybind11::module_& module);
void bind_grasps(pybind11::module_& module);
void bind_completion(pybind11::module_& module);
void bind_evaluation(pybind11::module_& module);

}  // namespace symscene::python
