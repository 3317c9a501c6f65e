#pragma once

#include "symscene/core/normal_estimation.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// The points of an object that have a normal. Where none has, normals are estimated first;
/// outwards is then away from `center`, which is true of most points of a closed or convex surface.
/// Throws InputError if the points span no surface.
PointCloud oriented_surface(PointCloud cloud, const Eigen::Vector3f& center,
                            const NormalEstimationOptions& options = {});

}  // namespace symscene
