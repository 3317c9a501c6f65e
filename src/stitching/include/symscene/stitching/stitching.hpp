#pragma once

#include <optional>

#include "symscene/core/stage_timer.hpp"
#include "symscene/reconstruction/surface_extraction.hpp"
#include "symscene/stitching/pair_pose.hpp"
#include "symscene/stitching/view_alignment.hpp"

namespace symscene {

struct StitchingOptions {
  MeasurementOptions measurement;
  FeatureOptions features;
  PairOptions pairs;
  ViewAlignmentOptions alignment;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("measurement", self.measurement);
    visit("features", self.features);
    visit("pairs", self.pairs);
    visit("alignment", self.alignment);
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

/// A pair of frames that were compared.
struct StitchedPair {
  std::size_t first = 0;
  std::size_t second = 0;
  PairPose pose;
};

/// What became of a frame.
struct StitchedFrame {
  std::optional<Eigen::Isometry3d> T_world_camera;  ///< none: it was left out
  std::size_t features = 0;
  ViewFit fit;              ///< to the other frames
  const char* reason = "";  ///< why it was left out
};

struct StitchingResult {
  std::vector<StitchedFrame> frames;
  std::vector<StitchedPair> pairs;  ///< all of them: (0, 1), (0, 2), ..., (1, 2), ...
  std::size_t placed = 0;           ///< frames that have a pose; none or at least two
  bool converged = false;           ///< of the alignment
  std::vector<StageTime> times;
};

/// Poses of a few frames from unknown viewpoints (section 4.6.2): pairs are joined by SIFT features
/// and PnP, chained along the surest of them, and all refined together by ICP. The first frame that
/// is placed stands at the origin. Frames that show nothing that others show are left out. The same
/// bits for any number of threads. Throws InputError if a frame has no colours, an image is not of
/// the camera's size, or the build has no OpenCV.
StitchingResult stitch_frames(std::span<const DepthFrame> frames, const CameraIntrinsics& camera,
                              const StitchingOptions& options = {});

}  // namespace symscene
