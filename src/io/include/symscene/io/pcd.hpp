#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// The points of a PCD file, version 0.6 or 0.7, ascii, binary or binary_compressed: x, y, z, if
/// there normal_x, normal_y, normal_z, and rgb or rgba (packed in a float or an integer). Other
/// fields are skipped; values, NaN too, are as in the file. `name` stands for the file in messages.
/// Throws InputError if the bytes are no such file.
PointCloud parse_pcd(std::string_view bytes, const std::string& name);
PointCloud read_pcd(const std::filesystem::path& path);

/// A PCD 0.7 file in binary encoding.
/// Throws InputError if normals or colours are not as many as the points.
std::string format_pcd(const PointCloud& cloud);

/// Writes format_pcd() atomically.
void write_pcd(const std::filesystem::path& path, const PointCloud& cloud);

}  // namespace symscene
