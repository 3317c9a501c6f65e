#pragma once

#include "boundary_points.hpp"

namespace symscene {

/// Joins paths end to end where one goes on as the other, the nearest ends first: the spanning tree
/// breaks every closed outline at its longest link. Two ends belong together if they are at most
/// `link_distance` apart and the directions of both paths, over `tangent_radius`, and that of the
/// gap turn by at most `corner_angle`. Ends of one path are not joined.
std::vector<PointIndices> joined_paths(const BoundaryNodes& nodes, std::vector<PointIndices> paths,
                                       const EdgeCurveOptions& options);

}  // namespace symscene
