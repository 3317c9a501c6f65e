#pragma once

#include "inverse_depth_plane.hpp"

namespace symscene {

/// What an image shows of a wall.
struct WallView {
  std::vector<DepthSample> samples;
  std::size_t measured = 0;                ///< samples, on the wall or not
  std::optional<InverseDepthPlane> truth;  ///< if it is known
  DepthViewReport report;
};

/// Errors of the samples of a view, each over depth, from a plane.
std::vector<float> errors_of(const WallView& view, const DepthCorrection& grid,
                             const InverseDepthPlane& plane, const CameraIntrinsics& camera);

/// The error within which samples count as on the plane, from their median.
double tolerance_of(std::vector<float> errors);

double root_mean_square(const std::vector<float>& errors, double tolerance);

/// The plane that best fits the corrected samples that lie within a tolerance of another.
InverseDepthPlane refitted(const WallView& view, const DepthCorrection& grid,
                           const InverseDepthPlane& plane, double tolerance,
                           const CameraIntrinsics& camera);

}  // namespace symscene
