#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symscene/core/depth_frame.hpp"

namespace symscene {

/// A depth image as the page shows it.
struct ShownDepth {
  std::size_t width = 0;   ///< [px]
  std::size_t height = 0;  ///< [px]
  /// Row by row: 255 for the nearest depth, 1 for the farthest, 0 where nothing was measured.
  std::vector<std::uint8_t> nearness = {};
};

/// The depth image of this camera [m], 0 where nothing was measured, with `coarser` × `coarser`
/// pixels in one: the nearest measured depth among them, so that thin things do not get lost.
/// Throws InputError if it has not one value per pixel, or `coarser` is 0.
ShownDepth shown_depth(std::span<const float> depth, const CameraIntrinsics& camera,
                       std::size_t coarser);

}  // namespace symscene
