#pragma once

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// The number of points after thinning to 5 mm.
std::size_t thinned_size(const Points& points, const PointIndices& indices);

}  // namespace symscene
