#pragma once

#include "symscene/core/point_cloud.hpp"
#include "symscene/occupancy/distance_field.hpp"

namespace symscene {

/// A sample of a set of points, to compare it with others.
struct SurfaceSample {
  Points positions;
  Points normals;
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  float radius = 0.0F;  ///< of the ball about the centre that holds it [m]
};

SurfaceSample sample_surface(const PointCloud& cloud, const PointIndices& points);

/// How much of two surfaces continues the other where nothing was seen between them, as that of an
/// object does which something before it hides in part: the share of points of the one whose
/// tangent plane is that of a point of the other, the smaller of both. Zero where surfaces are
/// farther apart than `reach` [m], or the space between those points was mostly seen empty.
double continuation(const SurfaceSample& a, const SurfaceSample& b, const DistanceField& field,
                    float reach);

}  // namespace symscene
