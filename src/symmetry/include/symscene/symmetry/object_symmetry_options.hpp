#pragma once

#include <numbers>

#include "symscene/core/options.hpp"
#include "symscene/core/tree_model.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

/// Parameters of the features of an axis. The model of axis probabilities was fitted with these
/// values.
struct AxisFeatureOptions {
  double ring_height = 0.005;
  double max_side_cosine = 0.5;
  double max_across_cosine = 0.17;
  double min_along_cosine = 0.9;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("ring_height", self.ring_height, "m", between(1e-4, 1.0),
          "height of the rings about the axis in which radii are compared (feature residual)");
    visit("max_side_cosine", self.max_side_cosine, "", between(0.0, 1.0),
          "points whose normals are nearer to the axis are flat ends, left out of residual");
    visit("max_across_cosine", self.max_across_cosine, "", between(0.0, 1.0),
          "greatest cosine of a normal and the axis that counts as across it (feature across)");
    visit("min_along_cosine", self.min_along_cosine, "", between(0.0, 1.0),
          "least cosine of a normal and the axis that counts as along it (feature along)");
  }
  void validate() const { check_fields(*this); }
};

/// Parameters of the features of a plane. The model of plane probabilities was fitted with these
/// values.
struct PlaneFeatureOptions {
  int max_points = 300;
  int max_neighbor_points = 120;
  int max_shell_points = 400;
  double min_plane_distance = 0.003;
  double max_image_distance = 0.008;
  double max_image_offset = 0.003;
  double max_image_angle = radians(20.0);
  double disagree_distance = 0.005;
  double min_empty_distance = 0.01;
  double max_exact_offset = 0.001;
  double min_exact_cosine = 0.985;
  double min_depth = 0.004;
  double max_depth = 0.12;
  double shell_gap = 0.008;
  double min_shell_cosine = 0.7;
  double max_across_cosine = 0.17;
  double min_facing_cosine = 0.9;
  double min_steep_cosine = 0.3;
  double tilt = radians(12.0);
  double shift = 0.08;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_points", self.max_points, "points", at_least(1),
          "points of the object that are reflected");
    visit("max_neighbor_points", self.max_neighbor_points, "points", at_least(1),
          "points that are reflected by tilted and shifted planes");
    visit("max_shell_points", self.max_shell_points, "points", at_least(1),
          "points of the surface that an image can be buried behind");
    visit("min_plane_distance", self.min_plane_distance, "m", at_least(0.0),
          "points nearer to the plane correspond to themselves and are ignored");
    visit("max_image_distance", self.max_image_distance, "m", above(0.0),
          "radius in which an image is compared with the surface");
    visit("max_image_offset", self.max_image_offset, "m", at_least(0.0),
          "greatest distance of an image from a tangent plane of the surface that it matches");
    visit("max_image_angle", self.max_image_angle, "rad", between(0.0, std::numbers::pi),
          "greatest angle between the normals of an image and the surface that it matches");
    visit("disagree_distance", self.disagree_distance, "m", at_least(0.0),
          "an unmatched image within this distance of an observed point counts as off the surface");
    visit("min_empty_distance", self.min_empty_distance, "m", at_least(0.0),
          "an image farther inside observed free space is in empty space");
    visit("max_exact_offset", self.max_exact_offset, "m", at_least(0.0),
          "greatest offset of an exact match");
    visit("min_exact_cosine", self.min_exact_cosine, "", between(-1.0, 1.0),
          "least cosine between the normals of an exact match");
    visit("min_depth", self.min_depth, "m", at_least(0.0),
          "least depth behind the surface of a buried image");
    visit("max_depth", self.max_depth, "m", at_least(0.0),
          "greatest depth behind the surface of a buried image");
    visit("shell_gap", self.shell_gap, "m", at_least(0.0),
          "greatest distance along the surface from a point that buries an image; grows with the "
          "spacing of the shell's points");
    visit("min_shell_cosine", self.min_shell_cosine, "", between(-1.0, 1.0),
          "least cosine between the normals of a buried image and of the surface before it");
    visit("max_across_cosine", self.max_across_cosine, "", between(0.0, 1.0),
          "greatest cosine of a normal and the plane's that lies in the plane (feature across)");
    visit("min_facing_cosine", self.min_facing_cosine, "", between(0.0, 1.0),
          "least cosine of a normal and the plane's that faces it (feature facing)");
    visit("min_steep_cosine", self.min_steep_cosine, "", between(0.0, 1.0),
          "least cosine of a normal and the plane's that is steep (feature steep_matched)");
    visit("tilt", self.tilt, "rad", strictly_between(0.0, std::numbers::pi / 2),
          "angle of the tilted planes that a plane is compared with (feature tilted)");
    visit("shift", self.shift, "", between(0.0, 1.0),
          "offset of the shifted planes that a plane is compared with, as share of the object's "
          "extent along the normal (feature shifted)");
  }
  void validate() const { check_fields(*this); }
};

/// Which symmetries an object has, once its points are known.
struct ObjectSymmetryOptions {
  double max_axis_residual = 0.05;
  double max_axis_occlusion = 0.05;
  double min_axis_coverage = 0.25;
  double min_axis_probability = 0.1;
  double min_implying_probability = 0.5;
  double min_plane_symmetry = 0.5;
  double min_plane_inlier = 0.05;
  double max_plane_occlusion = 0.15;
  double min_support_share = 0.8;
  double max_resting_gap = 0.03;
  double min_plane_matched = 0.05;
  double max_plane_contradicted = 0.3;
  double min_plane_probability = 0.5;
  double same_plane_angle = radians(12.0);
  double plane_in_axis_angle = radians(10.0);
  double plane_in_axis_distance = 0.01;
  AxisFeatureOptions axis_features;
  PlaneFeatureOptions plane_features;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_axis_residual", self.max_axis_residual, "", between(0.0, 1.0),
          "upper bound of the mean symmetry residual of an axis candidate (Eq. 3.5)");
    visit("max_axis_occlusion", self.max_axis_occlusion, "", between(0.0, 1.0),
          "upper bound of the mean occlusion residual of an axis candidate (Eq. 4.3)");
    visit("min_axis_coverage", self.min_axis_coverage, "", between(0.0, 1.0),
          "lower bound of the share of a full turn that is observed about an axis candidate");
    visit("min_axis_probability", self.min_axis_probability, "", between(0.0, 1.0),
          "least probability of a listed axis");
    visit("min_implying_probability", self.min_implying_probability, "", between(0.0, 1.0),
          "planes that hold an axis of at least this probability are implied and not listed");
    visit("min_plane_symmetry", self.min_plane_symmetry, "", between(0.0, 1.0),
          "lower bound of the symmetry score of a plane candidate (Eq. 3.9)");
    visit("min_plane_inlier", self.min_plane_inlier, "", between(0.0, 1.0),
          "lower bound of the inlier score of a plane candidate (Eq. 3.10)");
    visit("max_plane_occlusion", self.max_plane_occlusion, "", between(0.0, 1.0),
          "upper bound of the mean occlusion residual of a plane candidate (Eq. 4.7)");
    visit("min_support_share", self.min_support_share, "", between(0.0, 1.0),
          "a plane that the scene proposes is a candidate for an object that holds at least this "
          "share of its support");
    visit("max_resting_gap", self.max_resting_gap, "m", at_least(0.0),
          "an object whose lowest points are seen up to this height rests on the table: the "
          "candidate of a level plane is half way between the table and its top");
    visit("min_plane_matched", self.min_plane_matched, "", between(0.0, 1.0),
          "lower bound of the share of images on the surface of a plane candidate");
    visit(
        "max_plane_contradicted", self.max_plane_contradicted, "", between(0.0, 1.0),
        "upper bound of the share of images in empty space, inside the object or off its surface, "
        "among those that can be judged");
    visit("min_plane_probability", self.min_plane_probability, "", between(0.0, 1.0),
          "least probability of a listed plane");
    visit("same_plane_angle", self.same_plane_angle, "rad", at_least(0.0),
          "planes closer than this are one: a bounded body has no parallel planes of symmetry");
    visit("plane_in_axis_angle", self.plane_in_axis_angle, "rad", at_least(0.0),
          "a plane holds an axis, and follows from it, up to this angle between them");
    visit("plane_in_axis_distance", self.plane_in_axis_distance, "m", at_least(0.0),
          "a plane holds an axis, and follows from it, up to this distance between them");
    visit("axis_features", self.axis_features);
    visit("plane_features", self.plane_features);
  }
  void validate() const { check_fields(*this); }
};

/// Every option of the search for the symmetries of an object whose points are known.
struct SymmetrySearchOptions {
  bool rotational_stream = true;
  RotationalDetectionOptions rotational_detection;
  ReflectionalDetectionOptions reflectional_detection;
  ObjectSymmetryOptions object_symmetry;
  ModelChoice axis_model;   ///< not an option field: models are read with the configuration
  ModelChoice plane_model;  ///< as axis_model

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("rotational_stream", self.rotational_stream, "", any_value(),
          "search for rotation axes, not for reflection planes alone (section 4.5)");
    visit("rotational_detection", self.rotational_detection);
    visit("reflectional_detection", self.reflectional_detection);
    visit("object_symmetry", self.object_symmetry);
  }
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
