#pragma once

#include "depth_level.hpp"
#include "reconstruction/surface_image.hpp"

namespace symscene {

constexpr std::size_t normal_reach = 2;  ///< at the tracking image's full size [px]

/// The depth difference over squared depth that smooth() takes. [1/m]
inline float smoothing_noise(const MeasurementOptions& options) {
  return static_cast<float>(options.smoothing_sigmas) * static_cast<float>(options.noise);
}

/// Normals from the differences of the pixels `reach` to each side [px]; none where a depth
/// difference is larger than `step` at 1 m [m].
SurfaceImage with_normals(const DepthLevel& level, std::size_t reach, float step);

}  // namespace symscene
