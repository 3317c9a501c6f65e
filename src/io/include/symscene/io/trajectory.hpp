#pragma once

#include <filesystem>
#include <optional>
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

/// A 4×4 matrix, camera to world, row by row: nothing if a number is not finite, as where tracking
/// was lost. The rotation may be off by rounding; it is made a true one.
/// Throws InputError if the text is no such matrix.
std::optional<Eigen::Isometry3d> parse_pose_matrix(std::string_view text, const std::string& name);

/// The poses of a Redwood .log file, three whole numbers and a 4×4 matrix each, in the file's
/// order. The first number, that of the frame, stands for the time.
Trajectory parse_trajectory_log(std::string_view text, const std::string& name);

/// The pose at `time` between the two poses around it: positions linearly, rotations at an even
/// rate. Nothing outside the trajectory, or where the two are more than `largest_gap` apart. [s]
std::optional<Eigen::Isometry3d> pose_at(const Trajectory& trajectory, double time,
                                         double largest_gap);

}  // namespace symscene
