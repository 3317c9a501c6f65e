#pragma once

#include "symscene/core/options.hpp"
#include "symscene/reconstruction/measurement_options.hpp"

namespace symscene {

/// SIFT features (Lowe 2004) and their matching.
struct FeatureOptions {
  int max_features = 1500;
  double contrast = 0.01;
  double ratio = 0.85;
  double depth_step = 0.03;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_features", self.max_features, "", between(10.0, 20000.0),
          "features per image, the strongest");
    visit("contrast", self.contrast, "", strictly_between(0.0, 1.0),
          "least contrast of a feature (Lowe 2004, section 4)");
    visit("ratio", self.ratio, "", above_up_to(0.0, 1.0),
          "largest ratio of the distances to the nearest and the second nearest descriptor (Lowe "
          "2004, section 7.1)");
    visit("depth_step", self.depth_step, "m", above(0.0),
          "largest depth difference around a feature, at 1 m; features on the outline of an object "
          "move over the surface with the view");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// The relative pose of a pair of frames (section 4.6.2).
struct PairOptions {
  double reprojection = 4.0;
  int iterations = 2000;
  double confidence = 0.9999;
  int min_inliers = 12;
  double max_gap = 0.04;
  double tolerance = 0.02;
  double min_overlap = 0.05;
  double min_agreement = 0.8;
  double sweep_spreads = 6.0;
  double sweep_slack = 0.001;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("reprojection", self.reprojection, "px", above(0.0),
          "largest reprojection error of a match that agrees with a pose");
    visit("iterations", self.iterations, "", between(10.0, 1e6),
          "largest number of RANSAC samples");
    visit("confidence", self.confidence, "", strictly_between(0.0, 1.0),
          "confidence at which RANSAC ends");
    visit("min_inliers", self.min_inliers, "", at_least(6.0),
          "matches that must agree with a pose");
    visit("max_gap", self.max_gap, "m", above(0.0),
          "largest distance between the points of a match that agrees, at 1 m; grows with squared "
          "depth");
    visit("tolerance", self.tolerance, "m", above(0.0),
          "largest depth difference between two frames on one surface, beside three deviations");
    visit("min_overlap", self.min_overlap, "", above_up_to(0.0, 1.0),
          "share of the points of each frame that must lie on the surface of the other");
    visit("min_agreement", self.min_agreement, "", between(0.0, 1.0),
          "share of these points among those on the other's surface or in its free space");
    visit("sweep_spreads", self.sweep_spreads, "", between(0.0, 1e6),
          "for sweeps: greatest share of pixels that contradict a pose, in median absolute "
          "deviations above the median of consecutive frames");
    visit("sweep_slack", self.sweep_slack, "", between(0.0, 1.0),
          "constant added to that bound; poses from features also get tracking.max_disagreement");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// The joint alignment of all views.
struct ViewAlignmentOptions {
  int iterations_points = 10;
  int iterations_coarse = 10;
  int iterations_middle = 8;
  int iterations_fine = 6;
  double max_distance = 0.06;
  double max_angle = 0.6;
  double robust_sigmas = 2.0;
  double surface_deviation = 5e-4;
  double point_deviation = 0.01;
  double min_overlap = 0.02;
  double convergence = 1e-4;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("iterations_points", self.iterations_points, "", between(0.0, 1000.0),
          "iterations on pairs of points alone");
    visit("iterations_coarse", self.iterations_coarse, "", between(0.0, 1000.0),
          "iterations at a quarter of the tracking image's size");
    visit("iterations_middle", self.iterations_middle, "", between(0.0, 1000.0),
          "iterations at half of the tracking image's size");
    visit("iterations_fine", self.iterations_fine, "", between(1.0, 1000.0),
          "iterations at the tracking image's full size");
    visit(
        "max_distance", self.max_distance, "m", above(0.0),
        "largest distance between matched points on the coarsest level, halved on each finer one");
    visit("max_angle", self.max_angle, "rad", strictly_between(0.0, 1.5),
          "largest angle between matched normals");
    visit("robust_sigmas", self.robust_sigmas, "", above(0.0),
          "residual in deviations at which Cauchy's weight is one half");
    visit("surface_deviation", self.surface_deviation, "m", above(0.0),
          "standard deviation between two measured surfaces beside the noise of their depths");
    visit("point_deviation", self.point_deviation, "m", above(0.0),
          "standard deviation between paired points, at 1 m; grows with squared depth");
    visit("min_overlap", self.min_overlap, "", between(0.0, 1.0),
          "share of a view's pixels that must match another view for the pair to be used");
    visit("convergence", self.convergence, "", at_least(0.0),
          "largest step in m and rad at which a level ends");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

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
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
