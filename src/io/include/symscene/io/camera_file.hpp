#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/camera_model.hpp"

namespace symscene {

/// Whether a name is that of a calibrated camera, by its end: .yaml, .yml or .json.
bool is_camera_file(const std::filesystem::path& path);

/// Parses a camera.yaml (docs/formats.md), or the camera_info of ROS as camera_calibration writes
/// it or `rostopic echo` prints it. A name that ends in .json is JSON with the same members. Throws
/// InputError if the text is neither, the camera has another model of distortion, or this build
/// cannot read YAML.
CameraModel parse_camera_model(std::string_view text, const std::string& name);
CameraModel read_camera_model(const std::filesystem::path& path);

/// The text of a camera.yaml that parse_camera_model() reads back with the same bits, the
/// rotation of a pose up to rounding. Throws InputError if a number is not finite.
std::string format_camera_model(const CameraModel& camera);

}  // namespace symscene
