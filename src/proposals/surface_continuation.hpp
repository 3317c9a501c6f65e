#pragma once

#include "symscene/core/point_cloud.hpp"
#include "symscene/occupancy/distance_field.hpp"
#include "symscene/proposals/proposal_options.hpp"

namespace symscene {

/// A sample of a proposal's surface.
struct SurfaceSample {
  Points positions;
  Points normals;
  Eigen::Vector3f center = Eigen::Vector3f::Zero();
  float radius = 0.0F;  ///< of the ball about the centre that holds it [m]
};

/// At most `max_points` points, evenly spread over `points`.
SurfaceSample sample_surface(const PointCloud& cloud, const PointIndices& points, Index max_points);

/// How much two surfaces continue each other behind an occluder, in [0, 1]. A point continues the
/// other surface if some point there has the same tangent plane; the result is the smaller of both
/// shares of such points. Zero if the surfaces are farther apart than `max_gap`, or if the space
/// between continuing points was mostly seen empty.
double continuation(const SurfaceSample& a, const SurfaceSample& b, const DistanceField& field,
                    const ContinuationOptions& options);

}  // namespace symscene
