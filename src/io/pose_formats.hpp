#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "symscene/core/depth_frame.hpp"

namespace symscene {

/// Parses a 4×4 matrix, camera to world, by rows. Returns nothing if a number is not finite, as in
/// frames where tracking was lost. Rounding errors of the rotation are removed.
/// Throws InputError if the text is not a rigid 4×4 matrix.
std::optional<Eigen::Isometry3d> parse_pose_matrix(std::string_view text, const std::string& name);

/// Parses the poses of a Redwood .log file, each of three integers and a 4×4 matrix, in the order
/// of the file. StampedPose::time is the first integer, the number of the frame. Throws InputError.
Trajectory parse_trajectory_log(std::string_view text, const std::string& name);

/// Interpolates the pose at `time`: positions linearly, rotations spherically (slerp). Returns
/// nothing outside the trajectory, or if the poses before and after are more than `largest_gap`
/// apart. [s]
std::optional<Eigen::Isometry3d> pose_at(const Trajectory& trajectory, double time,
                                         double largest_gap);

}  // namespace symscene
