#pragma once

#include <optional>

#include "symscene/core/geometry.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/core/tree_model.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

/// Which symmetries an object has, once its points are known.
struct ObjectSymmetryBounds {
  double max_axis_misfit = 0.05;            ///< greatest mean angle score (Eq. 3.5)
  double max_axis_occlusion = 0.05;         ///< greatest mean occlusion score (Eq. 4.3)
  double min_axis_coverage = 0.25;          ///< of a full turn
  double min_axis_probability = 0.1;        ///< of an axis (axis_probability())
  double min_plane_matched = 0.05;          ///< least share of points whose image is on the surface
  double max_plane_contradicted = 0.3;      ///< greatest share of the images that can be judged
  double min_plane_probability = 0.4;       ///< of being a mirror (plane_probability())
  double max_image_offset = 0.003;          ///< of an image off the surface that it is on [m]
  double max_image_angle = radians(20.0);   ///< of its normal [rad]
  double same_plane_angle = radians(12.0);  ///< planes closer than this are one [rad]
  double min_plane_distance = 0.003;        ///< points nearer to a plane match themselves [m]
  double plane_in_axis_angle = radians(10.0);  ///< planes that hold an axis so nearly follow [rad]
  double plane_in_axis_distance = 0.01;        ///< and pass it this near [m]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_axis_misfit", self.max_axis_misfit, "", "greatest mean angle score of an axis");
    visit("max_axis_occlusion", self.max_axis_occlusion, "", "greatest occlusion of an axis");
    visit("min_axis_coverage", self.min_axis_coverage, "",
          "share of a full turn that is seen about an axis");
    visit("min_axis_probability", self.min_axis_probability, "",
          "least probability of an axis that is listed");
    visit("min_plane_matched", self.min_plane_matched, "",
          "least share of points whose image is on the surface");
    visit("max_plane_contradicted", self.max_plane_contradicted, "",
          "share of images that are in empty space, inside or off the surface");
    visit("min_plane_probability", self.min_plane_probability, "",
          "least probability of a plane that is listed");
    visit("max_image_offset", self.max_image_offset, "m", "of an image that is on the surface");
    visit("max_image_angle", self.max_image_angle, "rad", "of its normal");
    visit("same_plane_angle", self.same_plane_angle, "rad", "planes closer than this are one");
    visit("min_plane_distance", self.min_plane_distance, "m",
          "points nearer to a plane do not count");
    visit("plane_in_axis_angle", self.plane_in_axis_angle, "rad",
          "planes that hold an axis so nearly follow from it");
    visit("plane_in_axis_distance", self.plane_in_axis_distance, "m", "and pass it this near");
  }
  /// Throws InputError on a value below 0, or above 1 where it has no unit.
  void validate() const;
};

/// What was observed of the scene that an object is part of. What is referred to has to stay.
struct ObservedScene {
  const PointCloud& cloud;  ///< that the points of objects count in
  const DistanceField& field;
  const std::optional<Plane>& table;
};

/// How the symmetries of an object whose points are known are searched and bounded.
struct WholeObjectOptions {
  bool rotational_stream = true;  ///< without it no axis is sought
  RotationalDetectionOptions rotational_detection;
  ReflectionalDetectionOptions reflectional_detection;
  ObjectSymmetryBounds bounds;
  ModelChoice axis_model;
  ModelChoice plane_model;
};

}  // namespace symscene
