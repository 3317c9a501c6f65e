#pragma once

#include <span>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// All triangles of several meshes as one, without colours and normals.
TriangleMesh joined(std::span<const TriangleMesh> meshes);

}  // namespace symscene
