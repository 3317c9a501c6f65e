#pragma once

#include <vector>

#include "symscene/core/neighbors.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Spreads the signs of the normals at `seeds` to the points that are connected to them and not
/// visited, over a minimum spanning forest whose edges prefer parallel planes (Hoppe et al. 1992).
/// Returns the points that it visits, with the seeds.
PointIndices spread_signs(const PointIndices& seeds, const NeighborLists& lists, Points& normals,
                          std::vector<bool>& visited);

}  // namespace symscene
