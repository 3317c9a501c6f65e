#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "simulation/frame_fusion.hpp"
#include "surfels.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

std::vector<Surfel> all_surfels(std::span<const SensorFrame> frames, const CameraIntrinsics& camera,
                                const OrientedBox& region, const CloudFusionOptions& options) {
  std::vector<std::vector<Surfel>> by_frame(frames.size());
  parallel_for_each(frames.size(), [&](std::size_t i) {
    by_frame[i] = frame_surfels(frames[i], i, camera, region, options);
  });
  std::vector<Surfel> all;
  for (const auto& some : by_frame) all.insert(all.end(), some.begin(), some.end());
  return all;
}

FusedCloud to_cloud(const std::vector<Surfel>& surfels) {
  FusedCloud fused;
  const auto count = static_cast<Eigen::Index>(surfels.size());
  fused.cloud.positions.resize(count, 3);
  fused.cloud.normals.resize(count, 3);
  fused.cloud.colors.resize(count, 3);
  for (Index i = 0; i < surfels.size(); ++i) {
    fused.cloud.positions.row(i) = surfels[i].position.transpose();
    fused.cloud.normals.row(i) = surfels[i].normal.transpose();
    for (int c = 0; c < 3; ++c) {
      fused.cloud.colors(i, c) =
          static_cast<std::uint8_t>(std::clamp(surfels[i].color[c], 0.0F, 255.0F));
    }
    fused.objects.push_back(surfels[i].object);
  }
  return fused;
}

}  // namespace

FusedCloud fuse_cloud(std::span<const SensorFrame> frames, const CameraIntrinsics& camera,
                      const OrientedBox& region, const CloudFusionOptions& options) {
  options.validate();
  if (frames.size() > 64) {
    throw InputError("frames", "at most 64", std::to_string(frames.size()));
  }
  const std::vector<Surfel> measured = all_surfels(frames, camera, region, options);
  const std::vector<Surfel> averaged =
      averaged_in_voxels(measured, options.voxel_size, options.min_frames);
  if (averaged.empty()) return {};
  return to_cloud(
      averaged_in_voxels(flattened(averaged, options.smoothing), options.voxel_size, 1));
}

}  // namespace symscene
