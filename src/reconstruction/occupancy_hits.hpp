#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "symscene/reconstruction/occupancy_volume.hpp"

namespace symscene {

/// The place of a brick in the tree: 10 bits along each axis, x lowest.
using BrickKey = std::uint32_t;
constexpr BrickKey no_brick = ~BrickKey{0};

/// The voxels of one brick that pixels of some rows measure points in: places in the brick.
struct FoundInBrick {
  BrickKey brick = no_brick;
  std::vector<std::uint32_t> voxels;
};
struct BrickHits {
  BrickKey brick = no_brick;
  std::span<const std::uint32_t> voxels;
};

/// In which voxels the points lie that a frame measures.
class OccupancyHits {
 public:
  OccupancyHits(const DepthFrame& frame, const CameraIntrinsics& camera,
                const Eigen::Isometry3d& T_world_camera, const OccupancyVolumeOptions& options);

  /// By brick.
  std::span<const BrickHits> runs() const { return runs_; }

 private:
  std::vector<std::vector<FoundInBrick>> found_;  ///< by task
  std::vector<BrickHits> runs_;                   ///< of found_
};

}  // namespace symscene
