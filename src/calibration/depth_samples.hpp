#pragma once

#include <vector>

#include "symscene/calibration/depth_calibration.hpp"

namespace symscene {

/// A depth that stands for the pixels around it.
struct DepthSample {
  float u = 0.0F;      ///< [px]
  float v = 0.0F;      ///< [px]
  float depth = 0.0F;  ///< as measured [m]
};

/// Samples of a depth image, evenly spaced: the mean place and inverse depth of the pixels of a
/// block that lie near their median, which is exact on planes. None where less than half of a block
/// is measured or lies there.
std::vector<DepthSample> depth_samples(const std::vector<float>& depth,
                                       const CameraIntrinsics& camera,
                                       const DepthCorrectionOptions& grid);

/// Pixels [begin, end) of block `i` of `count` along an axis of `size` pixels.
struct PixelSpan {
  Index begin = 0;
  Index end = 0;
};
PixelSpan pixel_span(Index i, Index count, Index size);

}  // namespace symscene
