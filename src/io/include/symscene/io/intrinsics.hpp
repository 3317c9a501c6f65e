#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/camera.hpp"

namespace symscene {

/// The text of intrinsics.txt: "width height fx fy cx cy", in pixels. `name` stands for the file in
/// messages. Throws InputError if the text is no such camera.
CameraIntrinsics parse_intrinsics(std::string_view text, const std::string& name);
CameraIntrinsics read_intrinsics(const std::filesystem::path& path);

std::string format_intrinsics(const CameraIntrinsics& camera);

/// The camera of a Redwood (Open3D) JSON file: width, height and intrinsic_matrix by columns.
/// Throws InputError if the text is no such camera.
CameraIntrinsics parse_intrinsics_json(std::string_view text, const std::string& name);

/// Throws InputError unless focal lengths are positive, all numbers finite and the size is 0×0, for
/// not known, or that of an image that can be read.
void require_camera(const CameraIntrinsics& camera, const std::string& name);

}  // namespace symscene
