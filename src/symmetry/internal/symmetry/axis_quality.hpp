#pragma once

#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

/// The quality of `axis` on the points of `cloud`, which has unit normals; the worst possible if it
/// is empty.
AxisQuality axis_quality(const PointCloud& cloud, const RotationAxis& axis,
                         const DistanceField& field, const RotationalDetectionOptions& options);

/// The share of the full turn about `axis` that the points span: 1 − largest gap / 2π.
double angular_coverage(const Points& points, const RotationAxis& axis);

}  // namespace symscene
