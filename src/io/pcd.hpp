#pragma once

#include <string>
#include <string_view>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Parses a PCD file, version 0.6 or 0.7, ascii, binary or binary_compressed: x, y, z, and if
/// present normal_x, normal_y, normal_z and rgb or rgba (packed in a float or an integer). Other
/// fields are skipped; values that are not finite are kept. `name` is the name of the file in
/// messages. Throws InputError if the bytes are not a PCD file.
PointCloud parse_pcd(std::string_view bytes, const std::string& name);

/// A PCD 0.7 file in binary encoding.
/// Throws InputError unless there are no normals (colours) or one per point.
std::string format_pcd(const PointCloud& cloud);

}  // namespace symscene
