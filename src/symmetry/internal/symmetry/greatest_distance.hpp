#pragma once

#include "symscene/core/types.hpp"

namespace symscene {

/// The points that lie outermost in one of many directions, by ascending index.
PointIndices outermost_points(const Points& points);

/// The greatest distance between two points, within 0.1 %; zero for fewer than two. [m]
double greatest_distance(const Points& points);

}  // namespace symscene
