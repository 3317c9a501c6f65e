#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace symscene {

/// What is known of a voxel. Everything that no leaf covers was never seen.
enum class VoxelState : std::uint8_t { never_seen = 0, free = 1, occupied = 2 };

/// A cube of 2^level voxels a side of an octree of depth 16, free or occupied.
struct OccupancyLeaf {
  std::array<std::uint16_t, 3>
      key{};               ///< the least voxel of the cube; 32768 is the voxel [0, resolution)
  std::uint8_t level = 0;  ///< 0 is one voxel, 16 is the whole tree
  VoxelState state = VoxelState::free;
};

/// An occupancy octree as the list of its leaves in depth-first order (section 2.1.2).
struct OccupancyMap {
  double resolution = 0.005;  ///< edge of a voxel [m]
  std::vector<OccupancyLeaf> leaves;

  static constexpr int key_of_origin = 32768;
};

}  // namespace symscene
