#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/depth_frame.hpp"

namespace symscene {

/// Parses lines of "time tx ty tz qx qy qz qw" ([s], [m], unit quaternion; camera to world), the
/// format of the TUM RGB-D benchmark. Empty lines and text after # are skipped, quaternions are
/// scaled to unit length. `name` is the name of the file in messages.
/// Throws InputError if a line is not in this format or times decrease.
Trajectory parse_trajectory(std::string_view text, const std::string& name);
Trajectory read_trajectory(const std::filesystem::path& path);

/// One line per pose, in the format that parse_trajectory() reads.
std::string format_trajectory(const Trajectory& trajectory);

}  // namespace symscene
