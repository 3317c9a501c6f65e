#pragma once

#include <optional>
#include <span>
#include <vector>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/stage_timer.hpp"
#include "symscene/reconstruction/tracking_options.hpp"
#include "symscene/stitching/stitching_options.hpp"

namespace symscene {

/// A feature of one frame and one of another that look alike.
struct FeatureMatch {
  Index first = 0;
  Index second = 0;
};

/// How well the points of one frame fit the surface of another.
struct DepthAgreement {
  double overlap = 0.0;    ///< share of the points that lie on it
  double agreement = 0.0;  ///< share of these among the points on it or in space seen to be empty
};

/// The outcome of comparing two frames.
enum class PairStatus {
  accepted,      ///< the pose is known
  tracked,       ///< the pose is known from depth alone, in a sweep
  few_matches,   ///< too few features look alike
  few_inliers,   ///< too few of these agree on a pose
  little_shown,  ///< under that pose the frames have too little surface in common
  contradicted   ///< under that pose one frame has surface where the other has seen free space
};

const char* to_string(PairStatus status);

/// Whether the pose of a pair is known.
constexpr bool is_joined(PairStatus status) {
  return status == PairStatus::accepted || status == PairStatus::tracked;
}

/// The pose of a second camera relative to a first one, and its support.
struct PairPose {
  PairStatus status = PairStatus::few_matches;
  Eigen::Isometry3d T_first_second = Eigen::Isometry3d::Identity();
  std::size_t matches = 0;            ///< features that look alike
  std::vector<FeatureMatch> inliers;  ///< those that agree on the pose
  DepthAgreement depth;               ///< the worse of the two directions
};

/// A pair of frames that were compared.
struct StitchedPair {
  std::size_t first = 0;
  std::size_t second = 0;
  PairPose pose;
};

/// How a view fits the others.
struct ViewFit {
  std::size_t matches = 0;  ///< of its pixels with pixels of other views and vice versa
  double inliers = 0.0;     ///< share of these within three deviations
  double residual = 0.0;    ///< root mean square residual of the inliers [m]
};

/// The outcome for a frame.
struct StitchedFrame {
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< none if it was left out
  std::size_t features = 0;
  ViewFit fit;
  const char* reason = "";  ///< why it was left out
};

struct StitchingResult {
  std::vector<StitchedFrame> frames;
  std::vector<StitchedPair> pairs;  ///< all of them: (0, 1), (0, 2), ..., (1, 2), ...
  std::size_t placed = 0;           ///< frames that have a pose; none or at least two
  bool converged = false;           ///< of the alignment
  std::vector<StageTime> times;
};

/// Whether this build has OpenCV, which stitching needs.
bool has_feature_matcher();

/// Poses of a few frames from unknown viewpoints (section 4.6.2): pairs are joined by SIFT features
/// and PnP, chained along the pairs with most inliers, and refined together by ICP. The first
/// placed frame is at the origin. Frames without surface in common with others are left out. The
/// same bits for any number of threads. Throws InputError if a frame has no colours, an image is
/// not of the camera's size, or the build has no OpenCV.
StitchingResult stitch_frames(std::span<const DepthFrame> frames, const CameraIntrinsics& camera,
                              const StitchingOptions& options = {});

/// The same for the frames of a sweep, in its order. Where consecutive frames have too few features
/// in common, or some have no colours, the later is tracked in the earlier by depth.
StitchingResult stitch_sweep(std::span<const DepthFrame> frames, const CameraIntrinsics& camera,
                             const StitchingOptions& options = {},
                             const TrackingOptions& tracking = {});

}  // namespace symscene
