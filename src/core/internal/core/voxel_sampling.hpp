#pragma once

#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// One point for every voxel of a world-aligned grid that holds points: the means of their
/// positions, unit normals and colours, in the order of the voxels (x fastest). Points with a
/// coordinate that is not finite are left out, and so is a normal that is not finite or has no
/// length (a voxel without any, or where they cancel out, gets the zero vector). Throws InputError
/// if the cloud spans more than 2^20 voxels along an axis. [m]
PointCloud voxel_downsample(const PointCloud& cloud, double voxel_size);

}  // namespace symscene
