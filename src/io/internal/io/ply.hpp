#pragma once

#include <string>
#include <string_view>

#include "symscene/core/point_cloud.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Parses the vertices of a PLY file (ASCII, little or big endian): x, y, z, and if present nx, ny,
/// nz and red, green, blue (integers, or floats in [0, 1]). Other elements and properties are
/// skipped; values that are not finite are kept. `name` is the name of the file in messages. Throws
/// InputError if the bytes are not a PLY file.
PointCloud parse_ply_cloud(std::string_view bytes, const std::string& name);

/// Parses the vertices and faces of a PLY file, with normals and colours as above. Polygons are
/// split into fans about their first corner; faces with fewer than three corners are dropped.
/// Throws InputError if the bytes are not a PLY file, have no faces, or a face has an invalid
/// vertex index.
TriangleMesh parse_ply_mesh(std::string_view bytes, const std::string& name);

/// A little-endian PLY file with float positions and normals and uchar colours.
/// Throws InputError unless there are no normals (colours) or one per point.
std::string format_ply(const PointCloud& cloud);
std::string format_ply(const TriangleMesh& mesh);

}  // namespace symscene
