#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace symscene {

/// The first line of a .bt file.
inline constexpr std::string_view binary_octomap_line = "# Octomap OcTree binary file";

/// The header of an OctoMap file.
struct OctomapHeader {
  std::uint64_t size = 0;  ///< number of nodes, including leaves
  double resolution = 0.0;
};

/// Removes the header, which begins with `first_line`, from the front of `rest`. `kind` describes
/// such files in messages, `name` is the name of this one. Throws InputError.
OctomapHeader parse_octomap_header(std::string_view& rest, std::string_view first_line,
                                   const std::string& kind, const std::string& name);

std::string format_octomap_header(const OctomapHeader& header, std::string_view first_line);

/// Throws InputError unless the tree has as many nodes as its header declares.
void require_nodes(const OctomapHeader& header, std::uint64_t nodes, const std::string& name);

}  // namespace symscene
