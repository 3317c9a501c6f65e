#pragma once

#include "reconstruction/measurement.hpp"
#include "symscene/reconstruction/reconstruction.hpp"

namespace symscene {

/// The depth that a tenth of the measured pixels is nearer than; 0 if nothing is measured. [m]
double near_depth(const Measurement& measurement);

/// The options for a scene from this depth on: noise grows with distance, and voxels, truncation
/// distances and the margin of free space with it (TsdfOptions::voxel_sigmas).
ReconstructionOptions fitted_to_depth(ReconstructionOptions options, double depth);

}  // namespace symscene
