#pragma once

#include <cstddef>
#include <vector>

#include "symscene/core/occupancy_map.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// A dense grid of cubic voxels in the world frame, x running fastest.
struct VoxelFrame {
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();  ///< least corner of voxel (0, 0, 0) [m]
  float resolution = 0.005F;                         ///< edge of a voxel [m]
  Eigen::Vector3i size = Eigen::Vector3i::Zero();    ///< voxels along x, y and z

  std::size_t row_length() const { return static_cast<std::size_t>(size.x()); }
  std::size_t rows() const { return static_cast<std::size_t>(size.y()) * slices(); }
  std::size_t slices() const { return static_cast<std::size_t>(size.z()); }
  std::size_t slice_length() const { return row_length() * static_cast<std::size_t>(size.y()); }
  std::size_t voxels() const { return slice_length() * slices(); }
};

/// The state of every voxel of a box.
struct OccupancyGrid {
  VoxelFrame frame;
  std::vector<VoxelState> states;
};

constexpr int default_max_voxels = 1 << 28;

/// The voxels of `map` that cover `box`, on the map's own grid; voxels outside its leaves, which
/// are in depth-first order, are never seen. A box of more than `max_voxels` voxels gets voxels of
/// twice the size, up to 16 times: occupied where one of the eight is, free where all are. Throws
/// InputError if the box is empty, leaves the map's 2^16 voxels per side or has too many voxels
/// even so.
OccupancyGrid rasterize(const OccupancyMap& map, const Box& box,
                        int max_voxels = default_max_voxels);

}  // namespace symscene
