#pragma once

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Unit normals (V×3): the area-weighted means of the adjacent triangles' normals; zero at vertices
/// without a triangle.
Points vertex_normals(const TriangleMesh& mesh);

}  // namespace symscene
