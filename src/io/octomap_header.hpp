#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace symscene {

/// What an OctoMap file says before its nodes.
struct OctomapHeader {
  std::uint64_t size = 0;  ///< nodes, leaves too
  double resolution = 0.0;
};

/// Takes the header of a file that begins with `first_line` off the front of `rest`. `kind` stands
/// for such files in messages, `name` for this one.
OctomapHeader parse_octomap_header(std::string_view& rest, std::string_view first_line,
                                   const std::string& kind, const std::string& name);

std::string format_octomap_header(const OctomapHeader& header, std::string_view first_line);

/// Throws InputError unless the tree has as many nodes as its header says.
void require_nodes(const OctomapHeader& header, std::uint64_t nodes, const std::string& name);

}  // namespace symscene
