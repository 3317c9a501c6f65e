#pragma once

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Merges vertices at exactly equal positions, in the order of their first occurrence, whose colour
/// is kept. Triangles with two equal corners afterwards are dropped.
TriangleMesh weld_vertices(const TriangleMesh& mesh);

}  // namespace symscene
