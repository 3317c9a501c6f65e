#pragma once

#include "io/json_cursor.hpp"
#include "symscene/core/object_box.hpp"

namespace symscene {

/// The rotation of a pose as a unit quaternion with w not negative.
Eigen::Quaterniond orientation_of(const Eigen::Isometry3d& pose);

/// {"position_m": [x, y, z], "orientation_xyzw": [x, y, z, w]}; of a transform w is not negative.
/// Throws InputError, with `what` as the file, if a number is not finite.
Json pose_json(const ObjectPose& pose, const char* what);
Json pose_json(const Eigen::Isometry3d& pose, const char* what);

/// Reads the numbers as they are, so that a file that is read and written keeps its bytes. Throws
/// InputError unless the quaternion has unit length.
ObjectPose object_pose_of(const JsonCursor& json);

/// Reads a transform. Throws InputError as the above, and for further members.
Eigen::Isometry3d pose_of(const JsonCursor& json);

}  // namespace symscene
