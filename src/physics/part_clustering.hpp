#pragma once

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// How far the convex hull of a part of a surface reaches out over that surface, where `others` are
/// vertices beside the part's own to look at: the depth below planes that touch the hull, along
/// directions in which the surface there faces. Zero for a convex part with nothing in its hull.
/// [m]
double hollow_depth(const Points& vertices, const Points& normals, const PointIndices& part,
                    const PointIndices& others);

/// Joins neighbouring triangles, those first whose hull covers the least hollow, as long as that is
/// below `concavity` or there are more than `max_parts` parts. The vertices of each part,
/// ascending.
std::vector<PointIndices> cluster_convex(const TriangleMesh& mesh, double concavity,
                                         std::size_t max_parts);

}  // namespace symscene
