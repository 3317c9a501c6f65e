#pragma once

#include "symscene/symmetry/edge_curves.hpp"

namespace symscene {

/// Points between which curves are linked, without tangents.
using BoundaryNodes = std::vector<EdgeCurve::Point>;

/// The points of a cloud with a neighbour in another facet and, with `outlines`, those on the rim
/// of the surface, ascending.
PointIndices boundary_points(const PointCloud& cloud, const NeighborLists& neighbors,
                             std::span<const Index> facets, const EdgeCurveOptions& options);

/// Contracts the band of boundary points along each edge to nodes `spacing` apart.
BoundaryNodes boundary_nodes(const PointCloud& cloud, const PointIndices& boundary,
                             const EdgeCurveOptions& options);

}  // namespace symscene
