#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/geometry.hpp"

namespace symscene {

/// Parses the plane ax + by + cz + d = 0 from its four numbers a b c d [m], on one or more lines,
/// and scales it to a unit normal. `name` is the name of the file in messages. Throws InputError
/// unless there are four finite numbers, a, b, c not all zero.
Plane parse_table_plane(std::string_view text, const std::string& name);
Plane read_table_plane(const std::filesystem::path& path);

/// The four numbers, one per line. Reading them returns exactly the same plane.
std::string format_table_plane(const Plane& plane);

}  // namespace symscene
