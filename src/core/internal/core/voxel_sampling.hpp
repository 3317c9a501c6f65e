#pragma once

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// One point per occupied voxel of a world-aligned grid: the means of positions, unit normals and
/// colours, in the order of the voxels (x fastest). Points with a non-finite coordinate are left
/// out. Normals that are not finite or have no length are ignored; a voxel without a normal, or
/// whose normals cancel out, gets the zero vector. `voxel_size` is the edge of a voxel. [m] Throws
/// InputError if the cloud spans more than 2^20 voxels along an axis.
PointCloud voxel_downsample(const PointCloud& cloud, double voxel_size);

}  // namespace symscene
