#pragma once

#include <Eigen/Geometry>

#include "symscene/core/occupancy_map.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene::bench {

/// The points under a motion, which may mirror.
Points moved_points(const Points& points, const Eigen::Affine3d& motion);

/// The states of the map at the centres of voxels of the moved frame, `around` the moved points and
/// up to `margin` [m] from them. The motion may mirror.
OccupancyMap moved_occupancy(const OccupancyMap& map, const Eigen::Affine3d& T_moved_world,
                             const Points& around, double margin);

}  // namespace symscene::bench
