#pragma once

#include "symscene/core/types.hpp"

namespace symscene {

/// The greatest distance between two points, within 0.1 %; zero for fewer than two. [m]
double greatest_distance(const Points& points);

}  // namespace symscene
