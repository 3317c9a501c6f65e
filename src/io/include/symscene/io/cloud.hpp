#pragma once

#include <filesystem>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// The points of a PLY or PCD file, told apart by the first bytes.
/// Throws InputError if it is neither, or cannot be read.
PointCloud read_cloud(const std::filesystem::path& path);

}  // namespace symscene
