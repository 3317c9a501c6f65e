#pragma once

#include <cstddef>
#include <optional>

#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/symmetry/object_symmetry_options.hpp"

namespace symscene {

/// Features of an axis as a rotational symmetry of an object whose points are known.
struct AxisFeatures {
  double symmetry_residual = 0.0;   ///< as in AxisQuality
  double perpendicularity = 0.0;    ///< as in AxisQuality
  double coverage = 0.0;            ///< as in AxisQuality
  double occlusion_residual = 0.0;  ///< as in AxisQuality
  double residual = 0.0;    ///< mean difference of points' radii from the mean at their height [m]
  double height = 0.0;      ///< extent along the axis [m]
  double radius = 0.0;      ///< greatest distance from the axis [m]
  double off_centre = 0.0;  ///< distance of the axis from the points' mean, over the radius
  double across = 0.0;      ///< share of points with a normal at right angles to the axis
  double along = 0.0;       ///< share of points with a normal along the axis
  double roundness = 0.0;   ///< mean distance off the sphere through the points, over its radius
  double upright = 0.0;     ///< |cosine| of the axis and the table's normal; -1 without a table
  double size = 0.0;        ///< natural logarithm of the number of points

  /// Calls visit(name, value) for every feature, in this order.
  template <class Self, class Visit>
  static constexpr void visit_fields(Self& self, Visit&& visit) {
    visit("symmetry_residual", self.symmetry_residual);
    visit("perpendicularity", self.perpendicularity);
    visit("coverage", self.coverage);
    visit("occlusion_residual", self.occlusion_residual);
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
};

/// The features of `axis` on `points`, which has unit normals and is not empty; `quality` is the
/// axis' on the same points.
AxisFeatures axis_features(const PointCloud& points, const RotationAxis& axis,
                           const AxisQuality& quality, const std::optional<Plane>& table,
                           const AxisFeatureOptions& options = {});

}  // namespace symscene
