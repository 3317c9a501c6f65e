#pragma once

#include <optional>
#include <vector>

#include "symscene/core/geometry.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"

namespace symscene {

/// Planes from which fits start (section 3.5.3): orientations sampled about the principal axes of
/// `points` and, where `up` is known, upright ones; each at the median offset of the planes that
/// swap two of its points (Eq. 3.8). Points nearer to a plane than `min_plane_distance` [m] do not
/// vote for it. `points` has unit normals.
std::vector<ReflectionPlane> placed_planes(const PointCloud& points,
                                           const std::optional<Eigen::Vector3d>& up,
                                           double min_plane_distance,
                                           const PlanePlacementOptions& options);

}  // namespace symscene
