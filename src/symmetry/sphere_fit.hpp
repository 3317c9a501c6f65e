#pragma once

#include "symscene/core/types.hpp"

namespace symscene {

/// The mean distance of points off the sphere that fits them best (by algebraic distance), by its
/// radius; 1 where there is none, or one so large that they are nearly flat.
double distance_off_sphere(const Points& points);

}  // namespace symscene
