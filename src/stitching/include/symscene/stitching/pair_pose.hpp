#pragma once

#include "symscene/stitching/features.hpp"

namespace symscene {

struct PairOptions {
  double reprojection = 4.0;  ///< of a match that agrees with a pose [px]
  int iterations = 2000;      ///< of RANSAC at most
  int min_inliers = 12;       ///< matches that have to agree
  double max_gap = 0.04;      ///< between the two points of a match that agrees, at 1 m; grows with
                              ///< the square of the depth as noise does [m]
  double tolerance = 0.02;    ///< within which one frame's points lie on the other's surface,
                              ///< beside the noise of the depth [m]
  double min_overlap = 0.05;  ///< share of one frame's points that the other's surface shows too
  double min_agreement = 0.8;  ///< share of these among those that fall on or before the surface

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("reprojection", self.reprojection, "px", "of a match that agrees with a pose");
    visit("iterations", self.iterations, "", "of RANSAC at most");
    visit("min_inliers", self.min_inliers, "", "matches that have to agree");
    visit("max_gap", self.max_gap, "m", "between the points of a match that agrees, at 1 m");
    visit("tolerance", self.tolerance, "m", "within which points lie on a surface, beside noise");
    visit("min_overlap", self.min_overlap, "", "share of the points that both frames show");
    visit("min_agreement", self.min_agreement, "",
          "share of the points on the other's surface and not in its free space");
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

/// How well the points of one frame fit the other's surface.
struct DepthAgreement {
  double overlap = 0.0;    ///< share of the points that lie on it
  double agreement = 0.0;  ///< share of these among those on it or in space that is seen empty
};

/// What came of a pair of frames.
enum class PairStatus {
  accepted,      ///< the pose is known
  few_matches,   ///< too few features look alike
  few_inliers,   ///< too few of these agree on a pose
  little_shown,  ///< under that pose the frames do not show the same
  contradicted   ///< under that pose a frame has surface where the other sees through
};

const char* to_string(PairStatus status);

/// Where a second camera stood, seen from a first one, and why that is believed.
struct PairPose {
  PairStatus status = PairStatus::few_matches;
  Eigen::Isometry3d T_first_second = Eigen::Isometry3d::Identity();
  std::size_t matches = 0;            ///< features that look alike
  std::vector<FeatureMatch> inliers;  ///< those that agree on the pose
  DepthAgreement depth;               ///< the worse of the two directions
};

/// The pose of one frame in another from features that both have: PnP with RANSAC on the points of
/// either and the pixels of the other (section 4.6.2), the direction that more matches agree with;
/// then refined on these and checked against both depth images. Throws InputError if the build has
/// no OpenCV.
PairPose find_pair_pose(const ImageFeatures& first, const ImageFeatures& second,
                        const SurfaceImage& first_surface, const SurfaceImage& second_surface,
                        const CameraIntrinsics& camera, const FeatureOptions& matching,
                        const PairOptions& options, const MeasurementOptions& sensor);

/// How the points of `moved` lie to the surface that `fixed` shows.
DepthAgreement depth_agreement(const SurfaceImage& moved, const SurfaceImage& fixed,
                               const Eigen::Isometry3d& T_fixed_moved, double tolerance,
                               const MeasurementOptions& sensor);

}  // namespace symscene
