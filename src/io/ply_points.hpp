#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// A cloud with a mark per point: 1 if it was observed, 0 if completion added it.
struct MarkedCloud {
  PointCloud cloud;
  std::vector<std::uint8_t> observed;  ///< N, or empty if the file has no such property
};

/// Parses the vertices of a PLY file with their property "observed". Throws InputError.
MarkedCloud parse_ply_marked(std::string_view bytes, const std::string& name);

/// A PLY file with the extra property "observed" unless that is empty. Throws InputError.
std::string format_ply_marked(const PointCloud& cloud, std::span<const std::uint8_t> observed);

}  // namespace symscene
