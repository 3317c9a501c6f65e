#pragma once

#include "symscene/core/depth_noise.hpp"
#include "symscene/core/options.hpp"

namespace symscene {

/// Which windows of a depth image count as planar; their pixels take the plane's normal.
struct PlanarNormalOptions {
  double window_angle = 0.06;
  double min_filled = 0.5;
  double pixel_deviations = 2.0;
  double slope_deviations = 4.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("window_angle", self.window_angle, "rad", strictly_between(0.0, 1.0),
          "edge of a window as seen from the camera");
    visit("min_filled", self.min_filled, "", between(0.0, 1.0),
          "share of a window's pixels that must show a surface");
    visit("pixel_deviations", self.pixel_deviations, "", between(0.0, 100.0),
          "standard deviations within which a pixel lies on a window's plane");
    visit("slope_deviations", self.slope_deviations, "", between(0.0, 100.0),
          "standard deviations within which the slopes of neighbouring windows are of one plane");
  }
  void validate() const { check_fields(*this); }
};

/// When a plane dominates the model's view, and which pixels lie on it; they take its normal.
struct DominantPlaneOptions {
  double min_share = 0.5;
  double pixel_deviations = 4.0;
  double max_angle = 0.5;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("min_share", self.min_share, "", between(0.0, 1.0),
          "least share of the pixels with a surface that lie on the plane; 1 turns this off");
    visit("pixel_deviations", self.pixel_deviations, "", between(0.0, 100.0),
          "standard deviations of depth within which a pixel lies on the plane");
    visit("max_angle", self.max_angle, "rad", between(0.0, 1.5),
          "largest angle between the normals of the plane and of a pixel on it");
  }
  void validate() const { check_fields(*this); }
};

/// How depth images are prepared for tracking and fusion.
struct MeasurementOptions {
  double min_depth = 0.2;
  double max_depth = 6.0;
  double noise = structured_light_noise;
  double edge_step = 0.015;
  double max_edge_deviation = 0.0025;
  double smoothing_sigmas = 4.0;
  double min_cosine = 0.1;
  int tracking_width = 320;
  PlanarNormalOptions planar_normals;
  DominantPlaneOptions dominant_plane;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("min_depth", self.min_depth, "m", above(0.0), "nearer depths are ignored");
    visit("max_depth", self.max_depth, "m", strictly_between(0.0, 6.5),
          "farther depths are ignored");
    visit("noise", self.noise, "1/m", between(1e-6, 1.0),
          "standard deviation of a depth over its square (Khoshelham and Elberink 2012, Eq. 10)");
    visit("edge_step", self.edge_step, "m", above_up_to(0.0, 1.0),
          "depth step between neighbouring pixels, at 1 m, that makes an edge");
    visit("max_edge_deviation", self.max_edge_deviation, "m", between(0.0, 1.0),
          "largest standard deviation of a depth at which pixels beside edges are fused, if they "
          "lie on the surface around them");
    visit("smoothing_sigmas", self.smoothing_sigmas, "", above_up_to(0.0, 100.0),
          "depth difference in deviations at which the bilateral filter's weight falls to zero");
    visit("min_cosine", self.min_cosine, "", strictly_between(0.0, 1.0),
          "cosine of the angle between normal and ray from which a pixel is fused");
    visit("tracking_width", self.tracking_width, "px", at_least(40.0),
          "images are halved for tracking while they are at least 1.5 times as wide");
    visit("planar_normals", self.planar_normals);
    visit("dominant_plane", self.dominant_plane);
  }
  /// Throws InputError if a value is out of its range or max_depth is not above min_depth.
  void validate() const;

  /// The standard deviation of a depth (Khoshelham and Elberink 2012, Eq. 10). [m]
  double deviation(double depth) const { return noise * depth * depth; }
};

}  // namespace symscene
