#pragma once

#include <optional>
#include <string>

#include "frame_log.hpp"
#include "scene_output.hpp"
#include "symscene/stitching/stitching.hpp"

namespace symscene::app {

/// When the frames of a sequence are placed by stitching in place of tracking.
struct HandOverOptions {
  int max_frames = 30;
  double max_doubtful = 0.1;
  double max_rotation = radians(6.0);
  double min_placed = 0.8;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_frames", self.max_frames, "", at_least(0.0),
          "longer sequences are only tracked, as stitching compares all pairs of frames");
    visit("max_doubtful", self.max_doubtful, "", between(0.0, 1.0),
          "the sequence is stitched if more than this share of its usable frames is lost or "
          "degenerate");
    visit("max_rotation", self.max_rotation, "rad", at_least(0.0),
          "median rotation between consecutive frames above which they are placed by stitching");
    visit("min_placed", self.min_placed, "", at_least(0.0),
          "stitching is preferred if it places at least this share of the frames that tracking "
          "fuses");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// The options of stitching beside those that tracking has too.
struct SweepStitchingOptions {
  FeatureOptions features;
  PairOptions pairs;
  ViewAlignmentOptions alignment;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("features", self.features);
    visit("pairs", self.pairs);
    visit("alignment", self.alignment);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }

  StitchingOptions with(const MeasurementOptions& measurement) const {
    return {measurement, features, pairs, alignment};
  }
};

/// A sequence as tracked or stitched: the model, and which frames it is made of.
struct PlacedSequence {
  Reconstruction model;
  PlacedFrames placed;
  FrameLog log;
};

/// Frames of a sequence, and their numbers in it.
struct ReadFrames {
  std::vector<std::size_t> numbers;
  std::vector<DepthFrame> frames;
};

/// The frames that stitching placed, of those that were read for it.
PlacedFrames placed_frames(const StitchingResult& stitched, const ReadFrames& read);

/// The model of these frames.
Reconstruction fuse_placed(const StitchingResult& stitched, const ReadFrames& read,
                           const CameraIntrinsics& camera, const ReconstructionOptions& options);

/// Why the frames of a tracked sequence are better placed by stitching; empty if they are not,
/// or if there are no colours or no OpenCV to place them by.
std::string reason_to_stitch(const DepthSequence& sequence, const PlacedSequence& tracked,
                             const HandOverOptions& options);

/// The sequence placed by stitching, from its frames that can be read. None if that places no frame
/// or fewer than `min_placed`.
std::optional<PlacedSequence> stitch_sequence(const DepthSequence& sequence, std::size_t step,
                                              double min_placed, const StitchingOptions& stitching,
                                              const ReconstructionOptions& options,
                                              StageTimer& timer);

}  // namespace symscene::app
