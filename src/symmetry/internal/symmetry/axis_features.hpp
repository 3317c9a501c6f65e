#pragma once

#include <cstddef>
#include <optional>

#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

/// What speaks for and against an object whose points are known being a body of revolution about an
/// axis.
struct AxisFeatures {
  double symmetry = 0.0;          ///< as in RotationalScores
  double perpendicularity = 0.0;  ///< as in RotationalScores
  double coverage = 0.0;          ///< as in RotationalScores
  double occlusion = 0.0;         ///< as in RotationalScores
  double residual = 0.0;    ///< mean distance of points off the mean radius at their height [m]
  double height = 0.0;      ///< extent along the axis [m]
  double radius = 0.0;      ///< greatest distance from the axis [m]
  double off_centre = 0.0;  ///< distance of the axis from the points' mean, by the radius
  double across = 0.0;      ///< share of points with a normal at right angles to the axis
  double along = 0.0;       ///< share of points with a normal along the axis
  double roundness = 0.0;   ///< mean distance off the sphere through the points, by its radius
  double upright = 0.0;     ///< |cosine| of the axis and the table's normal; -1 without a table
  double size = 0.0;        ///< natural logarithm of the number of points

  /// Calls visit(name, value) for every measure, in this order.
  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("symmetry", self.symmetry);
    visit("perpendicularity", self.perpendicularity);
    visit("coverage", self.coverage);
    visit("occlusion", self.occlusion);
    visit("residual", self.residual);
    visit("height", self.height);
    visit("radius", self.radius);
    visit("off_centre", self.off_centre);
    visit("across", self.across);
    visit("along", self.along);
    visit("roundness", self.roundness);
    visit("upright", self.upright);
    visit("size", self.size);
  }
  static constexpr std::size_t count = 13;
};

/// `points` has normals and is not empty.
AxisFeatures measure_axis(const PointCloud& points, const RotationAxis& axis,
                          const RotationalScores& scores, const std::optional<Plane>& table);

}  // namespace symscene
