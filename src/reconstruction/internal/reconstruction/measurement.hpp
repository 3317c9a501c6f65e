#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "reconstruction/surface_image.hpp"
#include "symscene/core/depth_frame.hpp"

namespace symscene {

/// A depth image prepared for tracking and fusion.
struct Measurement {
  static constexpr float depth_unit = 1e-4F;  ///< of packed depths [m]

  CameraIntrinsics camera;

  /// One entry per pixel and an empty one at the end. Upper 16 bits: depth in depth_unit, 0 for
  /// none. Next 8 bits: factor from a depth difference to a distance from the surface, in 255ths.
  /// Low 8 bits: weight, in 16ths of that of a frontal view at 1 m.
  std::vector<std::uint32_t> packed;
  const Colors* colors = nullptr;  ///< of the frame, which must outlive this; null without

  std::vector<SurfaceImage> pyramid;  ///< finest first, each level half of the one before
  std::size_t measured = 0;           ///< pixels of the finest level with a surface
};

/// The packed weight of a frontal view from a depth. [16ths]
inline float frontal_weight(float depth) {
  const float squared = depth * depth;
  return std::floor(std::clamp(16.0F / std::max(squared * squared, 1e-6F), 1.0F, 255.0F));
}

/// Smooths a depth image for tracking, estimates normals, and weights every pixel for fusion by its
/// range and angle (section 2.1.1; Newcombe et al. 2011, section 3.2). Depths that are not finite
/// or out of range count as not measured. Throws InputError if the image is not of the camera's
/// size.
Measurement prepare_measurement(const DepthFrame& frame, const CameraIntrinsics& camera,
                                const MeasurementOptions& options);

}  // namespace symscene
