#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// OctoMap's trees are 16 levels deep; the root is at level 16, a voxel at level 0.
constexpr int octree_depth = 16;

/// Integer coordinates of a voxel along x, y and z.
using OctreeKey = std::array<std::uint16_t, 3>;

/// State of a voxel. Space that no leaf covers was never seen.
enum class VoxelState : std::uint8_t { never_seen = 0, free = 1, occupied = 2 };

/// A free or occupied cube in an octree of depth 16, with an edge of 2^level voxels.
struct OccupancyLeaf {
  OctreeKey key{};         ///< the lowest voxel of the cube; 32768 is the voxel [0, resolution)
  std::uint8_t level = 0;  ///< 0 is one voxel, 16 is the whole tree
  VoxelState state = VoxelState::free;
};

/// The states of a dense block of voxels, x fastest.
struct VoxelBlock {
  Eigen::Vector3i low = Eigen::Vector3i::Zero();   ///< key of the first voxel minus key_of_origin
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

/// A cube as in OccupancyLeaf, with the logarithm of its odds of being occupied.
struct LogOddsLeaf {
  OctreeKey key{};
  std::uint8_t level = 0;
  float log_odds = 0.0F;
};

/// An octree of log-odds, its leaves in depth-first order. It is larger on disk than an
/// OccupancyMap, but more frames can be added to it.
struct LogOddsMap {
  double resolution = 0.005;  ///< edge of a voxel [m]
  std::vector<LogOddsLeaf> leaves;
};

/// The occupied (log-odds of at least `threshold`) and free cubes, cubes of equal state joined. The
/// leaves must be in depth-first order.
OccupancyMap labels(const LogOddsMap& map, double threshold = 0.0);

}  // namespace symscene
