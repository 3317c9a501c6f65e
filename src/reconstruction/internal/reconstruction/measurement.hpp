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
  static constexpr float depth_unit = 1e-4F;     ///< of packed depths [m]
  static constexpr float weight_units = 256.0F;  ///< of a frontal view at 1 m

  CameraIntrinsics camera;

  /// One entry per pixel and an empty one at the end. Upper 16 bits: depth in depth_unit, 0 for
  /// none. Next 8 bits: factor from a depth difference to a distance from the surface, in 255ths.
  /// Low 8 bits: square root of the weight, 64 for a frontal view at 1 m: the range of weights from
  /// 0.5 to 4 m is too wide for their own 8 bits.
  std::vector<std::uint32_t> packed;
  const Colors* colors = nullptr;  ///< of the frame, which must outlive this; null without

  std::vector<SurfaceImage> pyramid;  ///< finest first, each level half of the one before
  std::size_t measured = 0;           ///< pixels of the finest level with a surface
};

/// The packed root of the weight of a view at an angle of this cosine to the normal. No view has
/// less than a unit, the weight of a frontal one at 4 m.
inline std::uint32_t packed_weight_root(float depth, float cosine) {
  const float root = 64.0F * cosine / std::max(depth * depth, 1e-3F);
  return static_cast<std::uint32_t>(std::clamp(root, 4.0F, 255.0F) + 0.5F);
}

/// The weight of a packed root. [Measurement::weight_units]
inline float weight_of_root(std::uint32_t root) {
  return static_cast<float>(root * root) * (Measurement::weight_units / (64.0F * 64.0F));
}

/// The weight of a frontal view from a depth. [Measurement::weight_units]
inline float frontal_weight(float depth) { return weight_of_root(packed_weight_root(depth, 1.0F)); }

/// Smooths a depth image for tracking, estimates normals, and weights every pixel for fusion by its
/// range and angle (section 2.1.1; Newcombe et al. 2011, section 3.2). Depths that are not finite
/// or out of range count as not measured. Throws InputError if the image is not of the camera's
/// size.
Measurement prepare_measurement(const DepthFrame& frame, const CameraIntrinsics& camera,
                                const MeasurementOptions& options);

}  // namespace symscene
