#pragma once

#include <span>

#include "io/json_cursor.hpp"
#include "symscene/core/camera.hpp"
#include "symscene/core/stage_timer.hpp"

namespace symscene {

// What files about views share (docs/formats.md).

/// {"width", "height", "fx", "fy", "cx", "cy"} in pixels.
Json camera_json(const CameraIntrinsics& camera);

/// [{"stage", "seconds"}, ...]
Json stage_times_json(std::span<const StageTime> times);

}  // namespace symscene
