#pragma once

#include <vector>

#include "node_grid.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The surface where a field is zero, and for every vertex the node of its edge that is nearer.
struct ZeroSurface {
  TriangleMesh mesh;
  std::vector<std::size_t> nodes;
};

/// Marching cubes (Lorensen and Cline 1987) with the triangles of cell_triangles(). Where all
/// border nodes are outside (not negative), each edge has exactly two triangles, which run along it
/// in opposite directions. No two vertices coincide.
ZeroSurface zero_surface(const NodeGrid& grid, const std::vector<float>& field);

}  // namespace symscene
