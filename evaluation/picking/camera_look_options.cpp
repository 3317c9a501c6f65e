#include "symscene/picking/camera_look_options.hpp"

#include "symscene/core/error.hpp"

namespace symscene {

void CameraLookOptions::validate() const {
  check_fields(*this);
  require_option(max_elevation >= min_elevation, "max_elevation", "at least min_elevation",
                 max_elevation);
  require_option(max_radius >= min_radius, "max_radius", "at least min_radius", max_radius);
}

CameraIntrinsics CameraLookOptions::intrinsics() const {
  return {static_cast<Index>(width), static_cast<Index>(height), focal_length, focal_length,
          0.5 * (width - 1),         0.5 * (height - 1)};
}

}  // namespace symscene
