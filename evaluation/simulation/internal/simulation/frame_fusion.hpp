#pragma once

#include <span>
#include <vector>

#include "symscene/core/occupancy_map.hpp"
#include "symscene/core/oriented_box.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/simulation/occupancy_fusion.hpp"
#include "symscene/simulation/sensor_frame.hpp"

namespace symscene {

/// A fused cloud and, per point, the object that most of its measurements show.
struct FusedCloud {
  PointCloud cloud;
  std::vector<Index> objects;  ///< per point, the number of the mesh
};

/// Fuses at most 64 frames with known poses into one oriented cloud of the surfaces inside
/// `region`, in the world frame. Points are averaged per voxel, separately for surfaces that face
/// different ways, and then moved along their normals onto the mean of their neighbourhood, so that
/// the cloud is a single layer like one from a truncated signed distance function. Throws
/// InputError if an option is out of range.
FusedCloud fuse_cloud(std::span<const SensorFrame> frames, const CameraIntrinsics& camera,
                      const OrientedBox& region, const CloudFusionOptions& options);

/// The occupancy of the space in `region` from frames with known poses. Voxels are projected into
/// every frame: they are free if enough frames look through them, occupied if enough frames measure
/// a point in them, otherwise never seen. The grid is OctoMap's: voxel k covers [k, k + 1) times
/// the resolution. World frame. Throws InputError if an option is out of range.
OccupancyMap fuse_occupancy(std::span<const SensorFrame> frames, const CameraIntrinsics& camera,
                            const OrientedBox& region, const OccupancyFusionOptions& options);

}  // namespace symscene
