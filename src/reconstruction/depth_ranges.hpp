#pragma once

#include <vector>

#include "reconstruction/tsdf_volume.hpp"

namespace symscene {

/// The range of depths in which every tile of an image may show surface. [m]
struct DepthRanges {
  static constexpr Index tile = 4;  ///< [px]

  Index columns = 0;            ///< tiles per row
  std::vector<float> nearest;   ///< infinity without surface
  std::vector<float> farthest;  ///< 0 without surface
};

/// Bounds the surface of a volume by the boxes of its blocks with surface.
DepthRanges find_depth_ranges(const TsdfVolume& volume, const CameraIntrinsics& camera,
                              const Eigen::Isometry3d& T_camera_world);

}  // namespace symscene
