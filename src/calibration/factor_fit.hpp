#pragma once

#include <span>

#include "depth_samples.hpp"

namespace symscene {

/// What a depth should be multiplied by.
struct FactorSample {
  DepthSample at;
  double factor = 1.0;
  double weight = 1.0;
};

/// A grid without factors (all 1) over the given depths. [m]
DepthCorrection empty_correction(const CameraIntrinsics& camera, double least_depth,
                                 double greatest_depth, const DepthCorrectionOptions& options);

/// Least squares fit of the factors of a grid to samples. Second differences along the axes are
/// penalised, so that factors are smooth; first differences a thousandth as much, so that cells
/// without samples continue their neighbours. Without any sample the grid stays.
DepthCorrection fitted(DepthCorrection grid, std::span<const FactorSample> samples,
                       const DepthCorrectionOptions& options);

}  // namespace symscene
