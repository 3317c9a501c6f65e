#pragma once

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The depth of the surface below the convex hull of a part of it: the largest distance of vertices
/// of the part, and of `others` inside the hull, to planes that touch the hull and face about the
/// same way as the surface there. Zero for a convex part with nothing in its hull. [m]
double hollow_depth(const Points& vertices, const Points& normals, const PointIndices& part,
                    const PointIndices& others);

/// Joins neighbouring triangles, in rising order of the hollow depth of their union, while that is
/// below `concavity` [m] or there are more than `max_parts` parts. Returns the vertices of each
/// part, ascending.
std::vector<PointIndices> cluster_convex(const TriangleMesh& mesh, double concavity,
                                         std::size_t max_parts);

}  // namespace symscene
