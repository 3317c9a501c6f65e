#pragma once

#include "view_space.hpp"

namespace symscene {

/// The never seen voxels on the rays of a view, each once per ray.
struct VoxelCounts {
  std::size_t unknown = 0;    ///< up to the first solid voxel
  std::size_t rear_side = 0;  ///< of these, the ones right before it (Isler et al. 2016)
};

/// Casts `columns` rays across the image, and as many down as make them evenly spaced.
VoxelCounts count_unknown(const ViewSpace& space, const CameraIntrinsics& camera,
                          const Eigen::Isometry3d& T_world_camera, int columns);

}  // namespace symscene
