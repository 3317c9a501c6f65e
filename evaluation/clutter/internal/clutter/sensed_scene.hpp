#pragma once

#include <span>

#include "symscene/clutter/clutter_methods.hpp"
#include "symscene/core/scene.hpp"

namespace symscene {

/// The scene that `symscene segment` makes of one depth image, or `symscene reconstruct` of several
/// with exact poses. World frame. Without points if nothing stands on the table, or no surface is
/// seen at the table that is given; a warning says the latter.
Scene sensed_scene(std::span<const ClutterView> views, const ClutterMethodOptions& options);

}  // namespace symscene
