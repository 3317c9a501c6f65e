#pragma once

#include "symscene/core/point_cloud.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The area of a mesh. [m²]
double surface_area(const TriangleMesh& mesh);

/// About `count` oriented points, distributed over a mesh by area with a low-discrepancy sequence
/// in every triangle; the same mesh gives the same points. Normals are those of the triangles,
/// colours those of the nearest vertex. Throws InputError if the mesh has no triangle of positive
/// area.
PointCloud sample_surface(const TriangleMesh& mesh, std::size_t count);

/// The same with one point per `spacing`² of area, or none if the mesh has no area. [m]
PointCloud sample_surface_at(const TriangleMesh& mesh, double spacing);

}  // namespace symscene
