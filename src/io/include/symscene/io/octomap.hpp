#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/occupancy_map.hpp"

namespace symscene {

/// Parses the leaves of an OctoMap binary tree (.bt), depth first. `name` is the name of the file
/// in messages. Throws InputError if the bytes are not an OctoMap file, end early, nest deeper than
/// 16, or the number of nodes differs from that in the header.
OccupancyMap parse_octomap(std::string_view bytes, const std::string& name);
OccupancyMap read_octomap(const std::filesystem::path& path);

/// An OctoMap binary tree with these leaves, which may be in any order. Leaves of state never_seen
/// are left out; a leaf that is the whole tree is written as its eight children. Throws InputError
/// if two leaves overlap, a key is not a multiple of its leaf's size, a level is above 16 or the
/// resolution is not positive.
std::string format_octomap(const OccupancyMap& map);

}  // namespace symscene
