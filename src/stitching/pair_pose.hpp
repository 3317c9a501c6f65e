#pragma once

#include "features.hpp"
#include "reconstruction/pose_fit.hpp"
#include "reconstruction/surface_image.hpp"

namespace symscene {

/// Input frame of the pair-pose estimate.
struct PairView {
  const FrameFeatures& features;
  const SurfaceImage& surface;  ///< against which the pose is checked
};

/// The pose of one frame in another from features that both have: PnP with RANSAC on the points of
/// either and the pixels of the other (section 4.6.2), in the direction with more inliers; then
/// refined on these and checked against both depth images. Throws InputError if the build has no
/// OpenCV.
PairPose find_pair_pose(const PairView& first, const PairView& second,
                        const CameraIntrinsics& camera, const StitchingOptions& options);

/// How well two depth images fit under a pose: the worse of the two directions.
DepthAgreement mutual_agreement(const SurfaceImage& first, const SurfaceImage& second,
                                const Eigen::Isometry3d& T_first_second, const DepthNoise& noise);
/// The same within the tolerance of poses from features.
DepthAgreement mutual_agreement(const SurfaceImage& first, const SurfaceImage& second,
                                const Eigen::Isometry3d& T_first_second,
                                const StitchingOptions& options);

/// Accepted if the depth images overlap and agree enough.
PairStatus status_of(const DepthAgreement& depth, const PairOptions& options);

}  // namespace symscene
