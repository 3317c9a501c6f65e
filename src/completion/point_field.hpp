#pragma once

#include "node_grid.hpp"
#include "surface_points.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// For every active node the nearest point; `none` for inactive nodes and for those that no path of
/// active nodes connects with a point.
struct NearestPoints {
  static constexpr Index none = ~Index{0};

  std::vector<Index> point;
  std::vector<float> squared_distance;  ///< [m²]
};

/// Exact within `reach` of the points; farther away the nearest of the candidates of neighbouring
/// nodes (Danielsson 1980), in sweeps that repeat until nothing changes. Only nodes whose distance
/// outside the object's convex bound is below `margin` are active.
NearestPoints nearest_points(const NodeGrid& grid, const SurfacePoints& points, float reach,
                             const std::vector<float>& in_bound, float margin);

/// The signed distance of every node from the surface, negative inside. Within `reach` of points it
/// is a weighted mean over those that face as the nearest one does, so that the faces of a thin
/// wall do not mix; farther away the distance from the tangent plane of the nearest point (Hoppe et
/// al. 1992). Nodes that are not active are outside, at `margin`. [m]
std::vector<float> signed_distances(const NodeGrid& grid, const SurfacePoints& points,
                                    const NearestPoints& nearest, float reach, float margin);

}  // namespace symscene
