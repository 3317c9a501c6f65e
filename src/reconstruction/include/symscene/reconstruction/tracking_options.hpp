#pragma once

#include "symscene/core/options.hpp"

namespace symscene {

/// Camera tracking against the model and relocalization of a lost camera.
struct TrackingOptions {
  int iterations_coarse = 8;
  int iterations_middle = 5;
  int iterations_fine = 4;
  double convergence = 1e-4;
  double max_distance = 0.10;
  double max_angle = 0.6;
  double robust_sigmas = 2.0;
  double model_deviation = 5e-4;
  double prior_deviation = 0.005;
  int min_matches = 50;
  double min_overlap = 0.3;
  double min_inliers = 0.5;
  double min_measured = 0.02;
  double degenerate_ratio = 5e-5;
  double flattened_degenerate_ratio = 5e-7;
  double max_translation = 0.25;
  double max_rotation = 0.5;
  double max_disagreement = 0.01;
  double disagreement_ratio = 3.0;
  double initial_disagreement = 0.05;
  double disagreement_gain = 0.25;
  double keyframe_distance = 0.15;
  double keyframe_angle = 0.26;
  double keyframe_depth_difference = 0.3;
  double relocalize_overlap = 0.5;
  double relocalize_inliers = 0.75;
  double relocalize_max_disagreement = 0.004;
  double relocalize_disagreement_ratio = 2.0;
  int relocalize_keyframes = 3;
  int relocalize_starts = 8;
  int relocalize_steps = 5;
  double relocalize_step = 0.05;
  double relocalize_distance = 0.025;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit_alignment_fields(self, visit);
    visit_pose_fields(self, visit);
    visit_relocalization_fields(self, visit);
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }

 private:
  /// How a frame is aligned with the model.
  template <class Self, class Visit>
  static void visit_alignment_fields(Self& self, Visit& visit) {
    visit("iterations_coarse", self.iterations_coarse, "", between(0.0, 100.0),
          "iterations at a quarter of the tracking image's size");
    visit("iterations_middle", self.iterations_middle, "", between(0.0, 100.0),
          "iterations at half of the tracking image's size");
    visit("iterations_fine", self.iterations_fine, "", between(1.0, 100.0),
          "iterations at the tracking image's full size");
    visit("convergence", self.convergence, "", between(0.0, 1.0),
          "step in m and rad below which a coarse or middle level ends");
    visit(
        "max_distance", self.max_distance, "m", above_up_to(0.0, 1e6),
        "largest distance between matched points on the coarsest level, halved on each finer one");
    visit("max_angle", self.max_angle, "rad", strictly_between(0.0, 1.5),
          "largest angle between matched normals");
    visit("robust_sigmas", self.robust_sigmas, "", above_up_to(0.0, 1e6),
          "residual in deviations at which Cauchy's weight is one half");
    visit("model_deviation", self.model_deviation, "m", above_up_to(0.0, 1e6),
          "standard deviation of the model's surface");
    visit("prior_deviation", self.prior_deviation, "m", above_up_to(0.0, 10.0),
          "standard deviation of poses that are given as a prior, as displacement of the scene");
  }

  /// Which poses are accepted.
  template <class Self, class Visit>
  static void visit_pose_fields(Self& self, Visit& visit) {
    visit("min_matches", self.min_matches, "", at_least(6.0),
          "fewer matched pixels than this do not determine a pose");
    visit("min_overlap", self.min_overlap, "", between(0.0, 1.0),
          "share of the measured pixels that must match the model");
    visit("min_inliers", self.min_inliers, "", between(0.0, 1.0),
          "share of the matches that must lie within three deviations");
    visit("min_measured", self.min_measured, "", between(0.0, 1.0),
          "share of the pixels that must be measured");
    visit("degenerate_ratio", self.degenerate_ratio, "", between(0.0, 1.0),
          "normalised eigenvalue of the normal equations below which a motion counts as "
          "unconstrained (Zhang and Singh 2016)");
    visit("flattened_degenerate_ratio", self.flattened_degenerate_ratio, "", between(0.0, 1.0),
          "the same where the pixels of a dominant plane have one normal, so that their noise does "
          "not look like a constraint");
    visit("max_translation", self.max_translation, "m", above_up_to(0.0, 1e6),
          "largest translation of the camera between two frames");
    visit("max_rotation", self.max_rotation, "rad", above_up_to(0.0, 1e6),
          "largest rotation of the camera between two frames");
    visit("max_disagreement", self.max_disagreement, "", between(0.0, 1.0),
          "slack on the share of pixels that disagree with the model");
    visit("disagreement_ratio", self.disagreement_ratio, "", above_up_to(0.0, 1e6),
          "a frame may disagree this many times as much as earlier frames, plus max_disagreement");
    visit("initial_disagreement", self.initial_disagreement, "", between(0.0, 1.0),
          "share of disagreeing pixels that is assumed before the first frame");
    visit("disagreement_gain", self.disagreement_gain, "", above_up_to(0.0, 1.0),
          "weight of the last frame in the running mean of the disagreement");
  }

  /// Which keyframes are kept, and how a lost camera is searched.
  template <class Self, class Visit>
  static void visit_relocalization_fields(Self& self, Visit& visit) {
    visit("keyframe_distance", self.keyframe_distance, "m", above_up_to(0.0, 1e6),
          "distance between keyframes");
    visit("keyframe_angle", self.keyframe_angle, "rad", above_up_to(0.0, 1e6),
          "angle between keyframes");
    visit("keyframe_depth_difference", self.keyframe_depth_difference, "m", above_up_to(0.0, 1e6),
          "depth difference at which a pixel of two keyframe thumbnails is entirely dissimilar");
    visit("relocalize_overlap", self.relocalize_overlap, "", between(0.0, 1.0),
          "min_overlap of a lost camera");
    visit("relocalize_inliers", self.relocalize_inliers, "", between(0.0, 1.0),
          "min_inliers of a lost camera");
    visit("relocalize_max_disagreement", self.relocalize_max_disagreement, "", between(0.0, 1.0),
          "max_disagreement of a lost camera");
    visit("relocalize_disagreement_ratio", self.relocalize_disagreement_ratio, "",
          above_up_to(0.0, 1e6), "disagreement_ratio of a lost camera");
    visit("relocalize_keyframes", self.relocalize_keyframes, "", between(0.0, 1000.0),
          "number of similar keyframes around which a lost camera is searched");
    visit("relocalize_starts", self.relocalize_starts, "", between(1.0, 1000.0),
          "number of poses around each place from which a lost camera is tracked");
    visit("relocalize_steps", self.relocalize_steps, "", between(0.0, 20.0),
          "steps of the search grid to each side");
    visit("relocalize_step", self.relocalize_step, "m", above_up_to(0.0, 1e6),
          "step of the search grid; rotations count by the displacement at the scene's border");
    visit("relocalize_distance", self.relocalize_distance, "m", above_up_to(0.0, 1e6),
          "largest distance between matched points in the search grid");
  }
};

}  // namespace symscene
