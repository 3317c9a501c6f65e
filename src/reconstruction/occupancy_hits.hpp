#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "brick_key.hpp"
#include "symscene/reconstruction/occupancy_volume.hpp"

namespace symscene {

/// Indices of the voxels of one brick in which pixels of some rows measure points.
struct FoundInBrick {
  BrickKey brick = no_brick;
  std::vector<std::uint32_t> voxels;
};
struct BrickHits {
  BrickKey brick = no_brick;
  std::span<const std::uint32_t> voxels;
};

/// The voxels in which the measured points of a frame lie.
class OccupancyHits {
 public:
  OccupancyHits(const DepthFrame& frame, const CameraIntrinsics& camera,
                const Eigen::Isometry3d& T_world_camera, const OccupancyVolumeOptions& options);

  /// Sorted by brick.
  std::span<const BrickHits> runs() const { return runs_; }
  std::span<const BrickHits> in_brick(BrickKey brick) const;

 private:
  std::vector<std::vector<FoundInBrick>> found_;  ///< by task
  std::vector<BrickHits> runs_;                   ///< of found_
};

}  // namespace symscene
