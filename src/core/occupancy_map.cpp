#include "symscene/core/occupancy_map.hpp"

#include <algorithm>

#include "core/octree.hpp"

namespace symscene {
namespace {

OccupancyLeaf occupancy_leaf(std::uint64_t code, int level, VoxelState state) {
  return {octree_key(code), static_cast<std::uint8_t>(level), state};
}

/// The states of the cubes of a block.
class BlockStates {
 public:
  explicit BlockStates(const VoxelBlock& block) : block_(block) {}

  std::optional<VoxelState> operator()(std::uint64_t code, int level) const {
    const OctreeKey key = octree_key(code);
    Eigen::Vector3i cell;
    for (int axis = 0; axis < 3; ++axis) {
      cell[axis] =
          int{key[static_cast<std::size_t>(axis)]} - OccupancyMap::key_of_origin - block_.low[axis];
      const bool outside = cell[axis] >= block_.size[axis] || cell[axis] + (1 << level) <= 0;
      if (outside) return VoxelState::never_seen;
    }
    if (level > 0) return std::nullopt;
    return block_.states[static_cast<std::size_t>(
        (std::int64_t{cell.z()} * block_.size.y() + cell.y()) * block_.size.x() + cell.x())];
  }

 private:
  const VoxelBlock& block_;
};

/// The labels of cubes. Queries in depth-first order pass over the leaves once.
class LeafLabels {
 public:
  LeafLabels(const std::vector<LogOddsLeaf>& leaves, double threshold)
      : leaves_(leaves), threshold_(threshold) {}

  std::optional<VoxelState> operator()(std::uint64_t code, int level) const {
    while (next_ < leaves_.size() && end(leaves_[next_]) <= code) ++next_;
    if (next_ == leaves_.size() || begin(leaves_[next_]) >= code + voxels_of(level)) {
      return VoxelState::never_seen;
    }
    if (leaves_[next_].level < level) return std::nullopt;
    return leaves_[next_].log_odds >= threshold_ ? VoxelState::occupied : VoxelState::free;
  }

 private:
  static std::uint64_t begin(const LogOddsLeaf& leaf) { return morton_code(leaf.key); }
  static std::uint64_t end(const LogOddsLeaf& leaf) { return begin(leaf) + voxels_of(leaf.level); }

  const std::vector<LogOddsLeaf>& leaves_;
  double threshold_;
  mutable std::size_t next_ = 0;
};

}  // namespace

OccupancyMap to_octree(const VoxelBlock& block, double resolution) {
  return {resolution, octree_leaves(VoxelState::never_seen, BlockStates(block), occupancy_leaf)};
}

OccupancyMap labels(const LogOddsMap& map, double threshold) {
  return {map.resolution,
          octree_leaves(VoxelState::never_seen, LeafLabels(map.leaves, threshold), occupancy_leaf)};
}

}  // namespace symscene
