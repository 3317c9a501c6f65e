#pragma once

#include <optional>
#include <vector>

#include "symscene/reconstruction/model_view.hpp"

namespace symscene {

struct TrackingOptions {
  int iterations_coarse = 8;         ///< at a quarter of the tracking image's size
  int iterations_middle = 5;         ///< at half of it
  int iterations_fine = 4;           ///< at its full size
  double max_distance = 0.10;        ///< between matched points on the coarsest level, halved on
                                     ///< each finer one [m]
  double max_angle = 0.6;            ///< between matched normals [rad]
  double robust_sigmas = 2.0;        ///< residual at which a match weighs half, in deviations
  double min_overlap = 0.3;          ///< share of the measured pixels that the model shows too
  double min_inliers = 0.5;          ///< share of the matches that agree to within three deviations
  double min_measured = 0.02;        ///< share of the pixels that must be measured
  double degenerate_ratio = 1e-4;    ///< constraint on a motion below which it counts as free
  double max_translation = 0.25;     ///< from one frame to the next [m]
  double max_rotation = 0.5;         ///< from one frame to the next [rad]
  double relocalize_overlap = 0.5;   ///< min_overlap where the camera is searched for
  double relocalize_inliers = 0.75;  ///< min_inliers where the camera is searched for
  double max_disagreement = 0.01;    ///< more than three times that of the frames before
  double keyframe_distance = 0.15;   ///< between keyframes [m]
  double keyframe_angle = 0.26;      ///< between keyframes [rad]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("iterations_coarse", self.iterations_coarse, "", "at a quarter of the image's size");
    visit("iterations_middle", self.iterations_middle, "", "at half of the image's size");
    visit("iterations_fine", self.iterations_fine, "", "at the tracking image's full size");
    visit("max_distance", self.max_distance, "m", "between matched points, coarsest level");
    visit("max_angle", self.max_angle, "rad", "between matched normals");
    visit("robust_sigmas", self.robust_sigmas, "", "deviations at which a match weighs half");
    visit("min_overlap", self.min_overlap, "", "share of measured pixels that the model shows");
    visit("min_inliers", self.min_inliers, "", "share of matches that agree");
    visit("min_measured", self.min_measured, "", "share of pixels that must be measured");
    visit("degenerate_ratio", self.degenerate_ratio, "",
          "constraint on a motion below which it counts as free");
    visit("max_translation", self.max_translation, "m", "from one frame to the next");
    visit("max_rotation", self.max_rotation, "rad", "from one frame to the next");
    visit("relocalize_overlap", self.relocalize_overlap, "", "overlap that finds a lost camera");
    visit("relocalize_inliers", self.relocalize_inliers, "", "inliers that find a lost camera");
    visit("max_disagreement", self.max_disagreement, "",
          "share of pixels that may disagree beyond three times that of before");
    visit("keyframe_distance", self.keyframe_distance, "m", "between keyframes");
    visit("keyframe_angle", self.keyframe_angle, "rad", "between keyframes");
  }
  /// Throws InputError where a value is out of its range.
  void validate() const;
};

enum class TrackingStatus {
  converged,   ///< the pose is known
  degenerate,  ///< the pose is known but for motions that the surface does not constrain
  lost         ///< the pose is not known
};

const char* to_string(TrackingStatus status);

/// The outcome of aligning a measurement with a view of the model.
struct TrackingResult {
  TrackingStatus status = TrackingStatus::lost;
  Eigen::Isometry3d T_world_camera = Eigen::Isometry3d::Identity();
  double overlap = 0.0;    ///< share of the measured pixels that were matched
  double inliers = 0.0;    ///< share of the matches within three deviations
  double agreement = 0.0;  ///< share of the measured pixels where the model shows something that
                           ///< match it within three deviations
  double residual = 0.0;   ///< root of the mean squared residual of those [m]
  std::vector<std::string> unconstrained;  ///< motions of the camera that are free, if degenerate
  const char* reason = "";                 ///< why it is lost
  bool searchable = true;  ///< the image shows enough that the camera may be looked for
};

/// Point-to-plane alignment of a measurement with a view of the model, from coarse to fine, points
/// being matched by projection (Newcombe et al. 2011, Eqs. 16 to 24). Residuals are weighed by the
/// noise of their depth and by Cauchy's function. Along motions that nothing constrains the camera
/// stays at `T_world_guess` (Zhang and Singh 2016). Lost, with the reason, if too little is
/// measured, matched or agrees, or the camera would have jumped from the view's place.
TrackingResult track_camera(const Measurement& measurement, const ModelView& view,
                            const Eigen::Isometry3d& T_world_guess, const TrackingOptions& options,
                            const MeasurementOptions& sensor);

/// At most `count` poses from which to track: the one given, then, best first, on a grid along the
/// three motions that the surface constrains least, those at which most pixels agree with the view.
/// A table looks the same from all along it; what stands on it does not. Empty where nothing
/// matches.
std::vector<Eigen::Isometry3d> likely_poses(const Measurement& measurement, const ModelView& view,
                                            const Eigen::Isometry3d& T_world_about,
                                            std::size_t count, const TrackingOptions& options,
                                            const MeasurementOptions& sensor);

}  // namespace symscene
