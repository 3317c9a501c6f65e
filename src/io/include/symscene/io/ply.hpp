#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/point_cloud.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// The vertices of a PLY file (ASCII, little or big endian): x, y, z, if there nx, ny, nz, and red,
/// green, blue (integers, or floats in [0, 1]). Other elements and properties are skipped; values,
/// NaN too, are as in the file. `name` stands for the file in messages.
/// Throws InputError if the bytes are no such file.
PointCloud parse_ply_cloud(std::string_view bytes, const std::string& name);
PointCloud read_ply_cloud(const std::filesystem::path& path);

/// The vertices and faces of a PLY file, with normals and colours as above. A polygon becomes a fan
/// of triangles about its first corner; faces with fewer than three corners are dropped. Throws
/// InputError if the bytes are no such file, have no faces, or a face names no vertex.
TriangleMesh parse_ply_mesh(std::string_view bytes, const std::string& name);
TriangleMesh read_ply_mesh(const std::filesystem::path& path);

/// A little-endian PLY file with float positions and normals and uchar colours.
/// Throws InputError if normals or colours are not as many as the points.
std::string format_ply(const PointCloud& cloud);
std::string format_ply(const TriangleMesh& mesh);

/// Writes format_ply() atomically.
void write_ply(const std::filesystem::path& path, const PointCloud& cloud);
void write_ply(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace symscene
