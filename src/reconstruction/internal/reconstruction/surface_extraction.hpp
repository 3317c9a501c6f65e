#pragma once

#include "reconstruction/tsdf_volume.hpp"
#include "symscene/core/triangle_mesh.hpp"
#include "symscene/reconstruction/surface_options.hpp"

namespace symscene {

/// The surface of a volume by marching cubes (Lorensen and Cline 1987), with normals from the
/// gradient of the field and colours where it has them. Ambiguous faces always separate the inside
/// corners, so cells meet without cracks: the surface of a body that was seen from all sides is
/// closed and every edge has two triangles. Vertices are shared, also between blocks. The order of
/// vertices and triangles does not depend on the number of threads.
TriangleMesh extract_surface(const TsdfVolume& volume,
                             const SurfaceExtractionOptions& options = {});

}  // namespace symscene
