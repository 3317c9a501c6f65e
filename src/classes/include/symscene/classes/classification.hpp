#pragma once

#include <numbers>
#include <optional>

#include "symscene/core/object_class.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/occupancy/distance_field.hpp"

namespace symscene {

/// Options of classify().
struct ClassOptions {
  bool enabled = true;
  bool complete_symmetries = true;
  int fit_points = 600;
  double face_angle = radians(20.0);
  double tolerance_spacing = 0.8;
  double tolerance_size = 0.02;
  double min_explained = 0.85;
  double max_empty = 0.1;
  double max_size_deviation = 0.2;
  double min_face_share = 0.04;
  double max_base_gap = 4.0;
  double square_tolerance = radians(10.0);
  double correlation = 3.0;
  double error_growth = 12.0;
  double fit_error = 0.6;
  double face_error = 0.25;
  double least_face_error = 0.12;
  double table_error = 0.13;
  double edge_error = 0.8;
  double least_edge_error = 0.25;
  double edge_offset = 0.25;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("enabled", self.enabled, "", any_value(),
          "determine the symmetry class of each object and its dimensions (section 4.7)");
    visit(
        "complete_symmetries", self.complete_symmetries, "", any_value(),
        "list the planes of boxes and the axes of cylinders that were fitted, also where they were "
        "not detected");
    visit("fit_points", self.fit_points, "", between(50, 100000),
          "most points of an object to which a surface is fitted");
    visit("face_angle", self.face_angle, "rad", above_up_to(0.0, std::numbers::pi / 4),
          "a point belongs to a face if its normal differs from the face's by at most this angle");
    visit("tolerance_spacing", self.tolerance_spacing, "", above(0.0),
          "a surface explains points up to this distance over their spacing");
    visit("tolerance_size", self.tolerance_size, "", at_least(0.0),
          "the same over the diagonal of the object; the larger bound counts");
    visit("min_explained", self.min_explained, "", between(0.0, 1.0),
          "least share of its points that a surface explains");
    visit("max_empty", self.max_empty, "", between(0.0, 1.0),
          "greatest share of a surface in space that was seen empty");
    visit("max_size_deviation", self.max_size_deviation, "", above(0.0),
          "greatest standard deviation of the radius or apothem of a surface, over its value");
    visit("min_face_share", self.min_face_share, "", between(0.0, 1.0),
          "least share of the points on a face that is observed");
    visit("max_base_gap", self.max_base_gap, "", at_least(0.0),
          "an object whose lowest points are at most this far above the table, over the spacing, "
          "stands on it");
    visit("square_tolerance", self.square_tolerance, "rad", between(0.0, std::numbers::pi / 4),
          "listed symmetries within this angle of right angles are fitted in one frame");
    visit("correlation", self.correlation, "", at_least(1.0),
          "distance over which errors of points are correlated, over the spacing");
    visit(
        "error_growth", self.error_growth, "", at_least(0.0),
        "systematic errors of dimensions follow e = r sqrt(1 + (this r / spacing)^2), r being the "
        "root mean square residual of the fit: a smooth error of depth hides in the fit, and grows "
        "faster than what remains");
    visit("fit_error", self.fit_error, "", at_least(0.0),
          "factor of e in place of the residual's deviation in the covariance of the fit");
    visit("face_error", self.face_error, "", at_least(0.0),
          "standard deviation of the place of an observed face or the radius, over e");
    visit("least_face_error", self.least_face_error, "", at_least(0.0),
          "least standard deviation of the place of an observed face or the radius, over the "
          "spacing");
    visit(
        "table_error", self.table_error, "", at_least(0.0),
        "standard deviation of the height of an object above the table, over e: a smooth error of "
        "depth shifts both");
    visit("edge_error", self.edge_error, "", at_least(0.0),
          "standard deviation of the end of a face, over e");
    visit("least_edge_error", self.least_edge_error, "", at_least(0.0),
          "least standard deviation of the end of a face, over the spacing");
    visit("edge_offset", self.edge_offset, "", any_value(),
          "distance of the end of a face beyond its last points, over the spacing");
  }
  /// Throws InputError on a field out of its range.
  void validate() const { check_fields(*this); }
};

/// An object whose class is determined. World frame.
struct ClassifiedObject {
  const PointCloud& points;                ///< with unit normals
  double spacing = 0.005;                  ///< of the points [m]
  const std::vector<ObjectAxis>& axes;     ///< its symmetries, by ascending residual
  const std::vector<ObjectPlane>& planes;  ///< the same
  const DistanceField& field;
  const std::optional<Plane>& table;
};

/// The simplest symmetry class that explains an object. Surfaces with few parameters, a sphere, a
/// cylinder, a regular prism or a box, are fitted to its points by Levenberg-Marquardt in shared
/// parameters (one frame, so that planes and axes are exactly perpendicular); of those that explain
/// the points the Bayesian information criterion (Schwarz 1978) chooses. An object that none
/// explains has the class of its symmetries, whose perpendicular planes are fitted together.
/// Lengths that the points do not constrain have no uncertainty but a reason. Throws InputError on
/// invalid options.
ObjectClass classify(const ClassifiedObject& object, const ClassOptions& options = {});

}  // namespace symscene
