#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/camera.hpp"

namespace symscene {

/// Parses intrinsics.txt: "width height fx fy cx cy" [px]. `name` is the name of the file in
/// messages. Throws InputError if the text is not in this format.
CameraIntrinsics parse_intrinsics(std::string_view text, const std::string& name);
CameraIntrinsics read_intrinsics(const std::filesystem::path& path);

/// The text that parse_intrinsics() reads.
std::string format_intrinsics(const CameraIntrinsics& camera);

}  // namespace symscene
