#include "voxel_counts.hpp"

#include <cmath>

#include "voxel_walk.hpp"

namespace symscene {
namespace {

void count_on_ray(const OccupancyGrid& grid, const Eigen::Vector3f& origin,
                  const Eigen::Vector3f& direction, VoxelCounts& counts) {
  bool was_unknown = false;
  for (VoxelWalk walk(grid.frame, origin, direction); walk.is_inside(); walk.advance()) {
    const VoxelState state = grid.states[walk.voxel()];
    if (state == VoxelState::occupied) {
      counts.rear_side += was_unknown ? 1 : 0;
      return;
    }
    was_unknown = state == VoxelState::never_seen;
    counts.unknown += was_unknown ? 1 : 0;
  }
}

}  // namespace

VoxelCounts count_unknown(const ViewSpace& space, const CameraIntrinsics& camera,
                          const Eigen::Isometry3d& T_world_camera, int columns) {
  const double step = static_cast<double>(camera.width) / columns;
  const Eigen::Vector3f origin = T_world_camera.translation().cast<float>();
  VoxelCounts counts;
  for (double v = 0.5 * step; v < static_cast<double>(camera.height); v += step) {
    for (double u = 0.5 * step; u < static_cast<double>(camera.width); u += step) {
      const Eigen::Vector3d ray = T_world_camera.linear() * camera.ray(u - 0.5, v - 0.5);
      count_on_ray(space.grid(), origin, ray.cast<float>(), counts);
    }
  }
  return counts;
}

}  // namespace symscene
