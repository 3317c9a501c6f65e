#pragma once

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The mesh with vertices at exactly the same place made one, in the order in which the places come
/// first; the first one's colour stays. Triangles that lose a corner by it are dropped.
TriangleMesh weld_vertices(const TriangleMesh& mesh);

}  // namespace symscene
