#pragma once

#include <vector>

#include "symscene/simulation/cloud_fusion.hpp"
#include "symscene/simulation/sensor_frame.hpp"

namespace symscene {

/// An oriented point of a surface, from one measurement or the mean of many.
struct Surfel {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< [m]
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  float weight = 0.0F;
  Index object = SensorFrame::nothing;
  std::uint64_t frames = 0;  ///< one bit per frame that saw it
};

/// The surfels of one frame inside the region, in the order of the pixels.
std::vector<Surfel> frame_surfels(const SensorFrame& frame, std::size_t frame_index,
                                  const CameraIntrinsics& camera, const OrientedBox& region,
                                  const CloudFusionOptions& options);

/// The mean of the surfels per voxel and side of a surface, in the order of the voxels. Means from
/// fewer than `min_frames` frames are dropped.
std::vector<Surfel> averaged_in_voxels(const std::vector<Surfel>& surfels, double voxel_size,
                                       int min_frames);

/// Moves surfels along their normals onto the mean of the neighbours that face the same way.
std::vector<Surfel> flattened(const std::vector<Surfel>& surfels, double smoothing);

}  // namespace symscene
