#include "core/image_checks.hpp"

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {

void require_pixels(std::size_t values, const CameraIntrinsics& camera, const std::string& what) {
  if (values == camera.pixels()) return;
  throw InputError(what, fmt::format("{}×{} values", camera.width, camera.height),
                   fmt::format("{}", values));
}

}  // namespace symscene
