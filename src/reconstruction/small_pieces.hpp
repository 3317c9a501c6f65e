#pragma once

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The mesh without its connected pieces of fewer than `min_triangles` triangles.
TriangleMesh without_small_pieces(const TriangleMesh& mesh, int min_triangles);

}  // namespace symscene
