#pragma once

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Unit vectors, the mean of the triangles' normals by area; zero where there is no triangle.
Points vertex_normals(const TriangleMesh& mesh);

}  // namespace symscene
