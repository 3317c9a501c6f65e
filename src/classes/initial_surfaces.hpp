#pragma once

#include <vector>

#include "surface_fit.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {

/// Surfaces near which fits to the samples start. `directions` (unit) are tried as axes besides
/// those that the normals propose.
std::vector<SurfaceModel> initial_surfaces(const FitSamples& samples,
                                           const std::vector<Eigen::Vector3d>& directions,
                                           const FitBounds& bounds);

}  // namespace symscene
