#pragma once

#include <optional>

#include "surface_points.hpp"
#include "symscene/core/geometry.hpp"

namespace symscene {

/// The axes of a tight box around an object's points, as columns in the world frame: z is the
/// table's normal or, without a table, the longest direction of the points; across it the sides of
/// the rectangle of least area. A lattice along them turns with the object.
Eigen::Matrix3d object_frame(const SurfacePoints& points, const std::optional<Plane>& table);

/// The points in another frame: each turned by `R_target_source`.
SurfacePoints turned(SurfacePoints points, const Eigen::Matrix3d& R_target_source);

}  // namespace symscene
