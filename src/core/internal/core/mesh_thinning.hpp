#pragma once

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// A ball. [m]
struct Ball {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  float radius = 0.0F;
};

/// The triangles whose corners are all finite and in the ball, and the vertices that they use.
TriangleMesh crop(const TriangleMesh& mesh, const Ball& ball);

/// Vertex clustering (Rossignac and Borrel 1993): vertices in one cell of a grid become one, their
/// mean, but for the two sides of a thin wall, which stay apart. A surface without a crack stays
/// without one. Vertices are finite; the result has normals, and colours where the mesh has them.
TriangleMesh cluster_vertices(const TriangleMesh& mesh, float cell);

/// The mesh as it is if it has at most `max_triangles`; otherwise clustered in the smallest cells,
/// from `smallest_cell` on, that leave no more of them. [m]
TriangleMesh thin(const TriangleMesh& mesh, Index max_triangles, float smallest_cell);

}  // namespace symscene
