#pragma once

#include "io/json_cursor.hpp"
#include "symscene/core/camera_model.hpp"

namespace symscene {

/// A whole number from 1 to `most`. Throws InputError if the value is none: numbers of YAML are
/// not told apart by their kind.
Index whole_number(const JsonCursor& value, std::size_t most);

/// Whether a document is a camera_info of ROS rather than a camera.yaml of SymScene.
bool is_ros_camera_info(const JsonCursor& root);

/// The camera of a camera_info: the file that camera_calibration writes (camera_matrix,
/// distortion_coefficients), or the message as ROS 1 (K, D) or ROS 2 (k, d) prints it. Throws
/// InputError if it is neither, or has another model of distortion than plumb_bob.
CameraModel ros_camera_info(const JsonCursor& root, const std::string& name);

}  // namespace symscene
