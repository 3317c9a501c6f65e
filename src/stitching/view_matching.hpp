#pragma once

#include "core/twist.hpp"
#include "reconstruction/point_to_plane.hpp"
#include "view_alignment.hpp"

namespace symscene {

/// Normal equations A ξ = −b of the motion of one view against another, both in the world. A motion
/// of one view has the effect of the opposite motion of the other, so 6×6 entries suffice.
struct PairSystem {
  Matrix6d A = Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();
  PoseFit fit;
};

/// A view's surface and its pose.
struct PlacedSurface {
  const SurfaceImage& image;
  const Eigen::Isometry3d& T_world_camera;
};

/// Matches the pixels of `moved` with those of `fixed` by projection; residuals are distances along
/// the normals of `fixed`.
PairSystem match_surfaces(const PlacedSurface& moved, const PlacedSurface& fixed,
                          const MatchOptions& options);

/// Residuals are the vectors between paired points.
PairSystem match_points(const PointPairs& pairs, const Eigen::Isometry3d& T_world_first,
                        const Eigen::Isometry3d& T_world_second,
                        const ViewAlignmentOptions& options);

}  // namespace symscene
