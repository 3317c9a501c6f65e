#pragma once

#include <cstddef>
#include <string>

#include "symscene/core/camera.hpp"

namespace symscene {

/// Throws InputError about `what` unless it has one value per pixel of the camera.
void require_pixels(std::size_t values, const CameraIntrinsics& camera, const std::string& what);

}  // namespace symscene
