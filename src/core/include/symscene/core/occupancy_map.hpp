#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "symscene/core/octree.hpp"

namespace symscene {

/// What is known of a voxel. Everything that no leaf covers was never seen.
enum class VoxelState : std::uint8_t { never_seen = 0, free = 1, occupied = 2 };

/// A cube of 2^level voxels a side of an octree of depth 16, free or occupied.
struct OccupancyLeaf {
  OctreeKey key{};         ///< the least voxel of the cube; 32768 is the voxel [0, resolution)
  std::uint8_t level = 0;  ///< 0 is one voxel, 16 is the whole tree
  VoxelState state = VoxelState::free;
};

/// What is known of a dense block of voxels, x fastest.
struct VoxelBlock {
  Eigen::Vector3i low = Eigen::Vector3i::Zero();   ///< key of the first voxel, less key_of_origin
  Eigen::Vector3i size = Eigen::Vector3i::Zero();  ///< in voxels
  std::vector<VoxelState> states;
};

/// An occupancy octree as the list of its leaves in depth-first order (section 2.1.2).
struct OccupancyMap {
  double resolution = 0.005;  ///< edge of a voxel [m]
  std::vector<OccupancyLeaf> leaves;

  static constexpr int key_of_origin = 32768;
};

/// The leaves of a block in depth-first order, cubes of equal state joined.
OccupancyMap to_octree(const VoxelBlock& block, double resolution);

/// A cube like OccupancyLeaf with how sure it is: the logarithm of the odds that it is occupied.
struct LogOddsLeaf {
  OctreeKey key{};
  std::uint8_t level = 0;
  float log_odds = 0.0F;
};

/// An octree that keeps how sure it is, in depth-first order: larger than an OccupancyMap
/// on disk, and what more frames can be added to.
struct LogOddsMap {
  double resolution = 0.005;  ///< edge of a voxel [m]
  std::vector<LogOddsLeaf> leaves;
};

/// What is occupied (log-odds of at least `threshold`) and what is free, cubes of equal state
/// joined. The leaves must be in depth-first order.
OccupancyMap labels(const LogOddsMap& map, double threshold = 0.0);

}  // namespace symscene
