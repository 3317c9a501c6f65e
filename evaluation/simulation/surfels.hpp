#pragma once

#include <vector>

#include "symscene/simulation/cloud_fusion.hpp"

namespace symscene {

/// A piece of surface, of one measurement or the mean of many.
struct Surfel {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< [m]
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  float weight = 0.0F;
  Index object = SensorFrame::nothing;
  std::uint64_t frames = 0;  ///< a bit for each frame that saw it
};

/// The surfels that one frame shows inside the region, in the order of its pixels.
std::vector<Surfel> frame_surfels(const SensorFrame& frame, std::size_t frame_index,
                                  const CameraIntrinsics& camera, const OrientedBox& region,
                                  const CloudFusionOptions& options);

/// The means of the surfels in each voxel, one for each side of a surface, in the voxels' order.
/// Means that fewer than `min_frames` frames saw are dropped.
std::vector<Surfel> averaged_in_voxels(const std::vector<Surfel>& surfels, double voxel_size,
                                       int min_frames);

/// Moves surfels along their normals onto the mean of the neighbours that face the same way.
std::vector<Surfel> flattened(const std::vector<Surfel>& surfels, double smoothing);

}  // namespace symscene
