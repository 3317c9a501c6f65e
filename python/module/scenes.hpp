#pragma once

#include <optional>
#include <string>

#include <pybind11/pybind11.h>

#include "symscene/core/geometry.hpp"
#include "symscene/workflow/known_table.hpp"

namespace symscene::python {

/// A plane from a, b, c, d with ax + by + cz + d = 0, scaled to a unit normal. Throws InputError
/// unless there are four finite numbers, a, b, c not all zero.
Plane plane_from(pybind11::handle value, const std::string& name);

/// What is told about a table: None (search it), False (there is none), or a, b, c, d. Throws
/// InputError for another value, and for `any_up` without a table to search.
KnownTable table_from(pybind11::handle value, bool any_up);

}  // namespace symscene::python
