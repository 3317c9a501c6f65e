#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/options.hpp"
#include "symscene/reconstruction/measurement.hpp"

namespace symscene {

struct ViewAlignmentOptions {
  int iterations_points = 10;     ///< on pairs of points alone
  int iterations_coarse = 10;     ///< at a quarter of the tracking image's size
  int iterations_middle = 8;      ///< at half of it
  int iterations_fine = 6;        ///< at its full size
  double max_distance = 0.06;     ///< between matched points on the coarsest level, halved on
                                  ///< each finer one [m]
  double max_angle = 0.6;         ///< between matched normals [rad]
  double robust_sigmas = 2.0;     ///< residual at which a match weighs half, in deviations
  double point_deviation = 0.01;  ///< of paired points from each other, at 1 m [m]
  double min_overlap = 0.02;      ///< share of a view's pixels that another has to match
  double convergence = 1e-4;      ///< of the largest step: a level ends there [m, rad]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("iterations_points", self.iterations_points, "", "on pairs of points alone");
    visit("iterations_coarse", self.iterations_coarse, "", "at a quarter of the image's size");
    visit("iterations_middle", self.iterations_middle, "", "at half of the image's size");
    visit("iterations_fine", self.iterations_fine, "", "at the tracking image's full size");
    visit("max_distance", self.max_distance, "m", "between matched points, coarsest level");
    visit("max_angle", self.max_angle, "rad", "between matched normals");
    visit("robust_sigmas", self.robust_sigmas, "", "deviations at which a match weighs half");
    visit("point_deviation", self.point_deviation, "m", "of paired points, at 1 m");
    visit("min_overlap", self.min_overlap, "", "share of a view's pixels that another matches");
    visit("convergence", self.convergence, "", "of the largest step in m or rad");
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

/// Places that two views are known to share.
struct PointPairs {
  std::size_t first = 0;           ///< view
  std::size_t second = 0;          ///< view
  Eigen::Matrix3Xd points_first;   ///< in the first camera's frame [m]
  Eigen::Matrix3Xd points_second;  ///< the same places in the second camera's frame [m]
};

/// How a view fits the others.
struct ViewFit {
  std::size_t matches = 0;  ///< of its pixels with pixels of other views, and of theirs with its
  double inliers = 0.0;     ///< share of these within three deviations
  double residual = 0.0;    ///< root of the mean squared residual of those [m]
};

struct ViewAlignment {
  std::vector<Eigen::Isometry3d> T_world_camera;
  std::vector<ViewFit> fits;  ///< one a view
  int iterations = 0;
  bool converged = false;  ///< the last step was below the bound
};

/// Aligns all views with each other at once (Chen and Medioni 1992, for many views): every pixel is
/// matched by projection with every other view that shows the same, and all poses but the first
/// move so that the distances along normals shrink, by Gauss-Newton from coarse to fine, weighed by
/// the noise of their depths and by Cauchy's function. Pairs of points hold what surfaces leave
/// free. The same bits for any number of threads.
ViewAlignment align_views(std::span<const Measurement> views,
                          std::span<const Eigen::Isometry3d> T_world_camera,
                          std::span<const PointPairs> pairs, const ViewAlignmentOptions& options,
                          const MeasurementOptions& sensor);

}  // namespace symscene
