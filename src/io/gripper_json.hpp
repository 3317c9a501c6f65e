#pragma once

#include "io/json_cursor.hpp"
#include "symscene/core/gripper.hpp"

namespace symscene {

/// The gripper as JSON; `what` stands for the file in messages.
Json gripper_json(const Gripper& gripper, const char* what);
/// Reads it. Throws InputError if a member is missing, unknown or out of its range.
Gripper gripper_of(const JsonCursor& json);

/// The rotation of a pose as a unit quaternion with w not negative.
Eigen::Quaterniond orientation_of(const Eigen::Isometry3d& pose);
/// {"position_m": [x, y, z], "orientation_xyzw": [x, y, z, w]}, w not negative.
Json pose_json(const Eigen::Isometry3d& pose, const char* what);
/// Reads it. Throws InputError unless the quaternion has unit length.
Eigen::Isometry3d pose_of(const JsonCursor& json);

}  // namespace symscene
