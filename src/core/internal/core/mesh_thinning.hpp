#pragma once

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// A ball. [m]
struct Ball {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  float radius = 0.0F;
};

/// The triangles whose corners are finite and inside the ball, with the vertices that they use.
TriangleMesh crop(const TriangleMesh& mesh, const Ball& ball);

/// Vertex clustering (Rossignac and Borrel 1993): the vertices of a grid cell are replaced by their
/// mean, separately for the two sides of a thin wall. A surface without cracks stays without
/// cracks. `cell` is the edge of a cell. [m] Vertices must be finite. The result has normals, and
/// colours if the mesh has them.
TriangleMesh cluster_vertices(const TriangleMesh& mesh, float cell);

/// The mesh unchanged if it has at most `max_triangles`; otherwise clustered in the smallest cells,
/// of at least `smallest_cell` [m], that reduce it to that number.
TriangleMesh thin(const TriangleMesh& mesh, Index max_triangles, float smallest_cell);

}  // namespace symscene
