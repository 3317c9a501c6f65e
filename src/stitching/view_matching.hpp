#pragma once

#include "core/twist.hpp"
#include "symscene/stitching/view_alignment.hpp"

namespace symscene {

/// The normal equations of the motion of one view against another, both in the world: a motion of
/// the one has the effect of the opposite motion of the other, so that 6×6 say all of it.
struct PairSystem {
  Matrix6d A = Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();
  std::size_t matches = 0;
  std::size_t inliers = 0;  ///< matches within three deviations
  double squares = 0.0;     ///< of their residuals [m²]
};

/// What decides about a match on one level.
struct MatchGates {
  double distance = 0.0;       ///< between matched points [m]
  double cosine = 0.0;         ///< between matched normals
  double robust_sigmas = 0.0;  ///< of Cauchy's function
};

/// A view's surface and where it is.
struct PlacedSurface {
  const SurfaceImage& image;
  const Eigen::Isometry3d& T_world_camera;
};

/// Matches the pixels of `moved` with those of `fixed` onto which they fall; residuals are
/// distances along the normals of `fixed`.
PairSystem match_surfaces(const PlacedSurface& moved, const PlacedSurface& fixed,
                          const MatchGates& gates, const MeasurementOptions& sensor);

/// Residuals are the vectors between paired points.
PairSystem match_points(const PointPairs& pairs, const Eigen::Isometry3d& T_world_first,
                        const Eigen::Isometry3d& T_world_second,
                        const ViewAlignmentOptions& options);

}  // namespace symscene
