#pragma once

#include <optional>

#include "symscene/core/point_cloud.hpp"
#include "symscene/symmetry/sphere_options.hpp"

namespace symscene {

/// The mean distance of points off the sphere that fits them best (by algebraic distance), by its
/// radius; 1 where there is none, or one so large that the points are nearly flat.
double distance_off_sphere(const Points& points);

/// The centre if the surface is a sphere: normals along the radii, all radii alike. `cloud` has
/// unit normals.
std::optional<Eigen::Vector3d> sphere_center(const PointCloud& cloud, const SphereOptions& options);

}  // namespace symscene
