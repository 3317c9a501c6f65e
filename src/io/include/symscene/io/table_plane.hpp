#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/geometry.hpp"

namespace symscene {

/// The plane ax + by + cz + d = 0 from the text of its four numbers a b c d, on one line or more,
/// scaled to a unit normal. [m] `name` stands for the file in messages.
/// Throws InputError unless there are four finite numbers, a, b, c not all zero.
Plane parse_table_plane(std::string_view text, const std::string& name);
Plane read_table_plane(const std::filesystem::path& path);

/// The four numbers, one a line, so that reading gives the same plane.
std::string format_table_plane(const Plane& plane);

/// Writes format_table_plane() atomically.
void write_table_plane(const std::filesystem::path& path, const Plane& plane);

}  // namespace symscene
