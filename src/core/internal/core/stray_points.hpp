#pragma once

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// The points that have at least `min_neighbors` other points within `radius` [m], ascending. The
/// rest are stray points, such as flying pixels between the camera and the scene. Throws InputError
/// if the points span too many cells of that radius for memory.
PointIndices points_with_neighbors(const Points& points, double radius, int min_neighbors);

}  // namespace symscene
