#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/depth_frame.hpp"

namespace symscene {

/// Lines of "time tx ty tz qx qy qz qw", camera to world; empty lines and lines after # are
/// skipped, quaternions are scaled to unit length. `name` stands for the file in messages.
/// Throws InputError if a line is no such pose or times fall.
Trajectory parse_trajectory(std::string_view text, const std::string& name);
Trajectory read_trajectory(const std::filesystem::path& path);

std::string format_trajectory(const Trajectory& trajectory);

/// Writes format_trajectory() atomically.
void write_trajectory(const std::filesystem::path& path, const Trajectory& trajectory);

}  // namespace symscene
