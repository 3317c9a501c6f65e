#pragma once

#include <string>
#include <string_view>

#include "symscene/core/camera.hpp"

namespace symscene {

/// Parses a Redwood (Open3D) camera file: JSON with width, height and intrinsic_matrix (by
/// columns). Throws InputError if the text is not a valid camera file.
CameraIntrinsics parse_intrinsics_json(std::string_view text, const std::string& name);

/// Throws InputError unless focal lengths are positive, all numbers are finite and the size is that
/// of an image that can be read, or 0×0 for unknown.
void require_camera(const CameraIntrinsics& camera, const std::string& name);

}  // namespace symscene
