#pragma once

#include <vector>

#include "symscene/core/camera.hpp"

namespace symscene {

constexpr std::size_t image_rows_per_task = 16;

/// A depth image of one pyramid level, 0 where nothing was measured.
struct DepthLevel {
  CameraIntrinsics camera;
  std::vector<float> depth;  ///< [m]
};

/// The depths between `min` and `max`; all others, and those that are not finite, become 0.
DepthLevel keep_in_range(const std::vector<float>& depth, const CameraIntrinsics& camera,
                         double min, double max);

/// Half the size. A pixel is the mean of those of 2×2 pixels that are within `step`, relative to
/// their depth, of the nearest of them; 0 if these are fewer than two.
DepthLevel halve(const DepthLevel& fine, float step);

/// Holes of one pixel get the mean of two neighbours on opposite sides, or else at opposite
/// corners, that differ by at most `step` at 1 m [m]: one surface, of which a sensor or the
/// registration to another camera has left out single pixels or a grid of lines.
DepthLevel bridge_holes(const DepthLevel& raw, float step);

/// A bilateral filter over 5×5 pixels: weights fall to zero at a difference of `noise` times the
/// squared depth. [1/m]
DepthLevel smooth(const DepthLevel& raw, float noise);

}  // namespace symscene
