#pragma once

#include <string>

#include "symscene/core/geometry.hpp"

namespace symscene {

/// "a,b,c,d", as `--plane` takes a table: ax + by + cz + d = 0.
std::string plane_text(const Plane& plane);

}  // namespace symscene
