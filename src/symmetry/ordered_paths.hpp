#pragma once

#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// The minimum spanning forest over points with links of at most `link_distance`, split into paths
/// without branches: the longest path of each tree, then those of what is left of it. Every point
/// is on one path, each path in order. [m]
std::vector<PointIndices> ordered_paths(const Points& points, double link_distance);

}  // namespace symscene
