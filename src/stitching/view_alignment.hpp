#pragma once

#include <span>
#include <vector>

#include "reconstruction/measurement.hpp"
#include "symscene/stitching/stitching.hpp"

namespace symscene {

/// Points of the scene that two views have in common.
struct PointPairs {
  std::size_t first = 0;           ///< view
  std::size_t second = 0;          ///< view
  Eigen::Matrix3Xd points_first;   ///< in the first camera's frame [m]
  Eigen::Matrix3Xd points_second;  ///< the same points in the second camera's frame [m]
};

struct ViewAlignment {
  std::vector<Eigen::Isometry3d> T_world_camera;
  std::vector<ViewFit> fits;  ///< one per view
  int iterations = 0;
  bool converged = false;  ///< the last step was below the bound
};

/// Aligns all views with each other at once (Chen and Medioni 1992, for many views): every pixel is
/// matched by projection with every other view that shows the same surface, and all poses but the
/// first minimise the point-to-plane distances by Gauss-Newton from coarse to fine, weighted by the
/// noise of their depths and by Cauchy's function. Pairs of points constrain the motions that
/// surfaces leave free. The same bits for any number of threads. Throws InputError if views, poses
/// and pairs do not go together.
ViewAlignment align_views(std::span<const Measurement> views,
                          std::span<const Eigen::Isometry3d> T_world_camera,
                          std::span<const PointPairs> pairs, const ViewAlignmentOptions& options,
                          const MeasurementOptions& sensor);

}  // namespace symscene
