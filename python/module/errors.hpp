#pragma once

#include <pybind11/pybind11.h>

namespace symscene::python {

/// Adds symscene.InputError, which functions of the library raise as what they throw.
void bind_errors(pybind11::module_& module);

}  // namespace symscene::python
