#include <algorithm>
#include <optional>

#include "symscene/simulation/occupancy_fusion.hpp"

namespace symscene {
namespace {

constexpr int depth = 16;

class LeafCollector {
 public:
  LeafCollector(const VoxelBlock& block, std::vector<OccupancyLeaf>& leaves)
      : block_(block), leaves_(leaves) {
    low_ = block.low.array() + OccupancyMap::key_of_origin;
    high_ = low_ + block.size;
  }

  /// Adds the leaves of the cube at `key`; the state if it is the same throughout.
  std::optional<VoxelState> collect(const Eigen::Vector3i& key, int level) {
    const int edge = 1 << level;
    if ((key.array() >= high_.array()).any() || (key.array() + edge <= low_.array()).any()) {
      return VoxelState::never_seen;
    }
    const std::size_t before = leaves_.size();
    const std::optional<VoxelState> state = level == 0 ? at(key) : collect_children(key, level);
    if (state && *state != VoxelState::never_seen) {
      leaves_.resize(before);
      OccupancyLeaf leaf;
      for (unsigned axis = 0; axis < 3; ++axis) {
        leaf.key[axis] = static_cast<std::uint16_t>(key[axis]);
      }
      leaf.level = static_cast<std::uint8_t>(level);
      leaf.state = *state;
      leaves_.push_back(leaf);
    }
    return state;
  }

 private:
  std::optional<VoxelState> collect_children(const Eigen::Vector3i& key, int level) {
    const int half = 1 << (level - 1);
    std::optional<VoxelState> common;
    bool equal = true;
    for (int child = 0; child < 8; ++child) {  // OctoMap's order: x is the lowest bit
      const Eigen::Vector3i offset(child & 1, (child >> 1) & 1, child >> 2);
      const std::optional<VoxelState> state = collect(key + half * offset, level - 1);
      if (child == 0) common = state;
      equal = equal && state && state == common;
    }
    return equal ? common : std::nullopt;
  }

  VoxelState at(const Eigen::Vector3i& key) const {
    const Eigen::Vector3i cell = key - low_;
    return block_.states[static_cast<std::size_t>(
        (std::int64_t{cell.z()} * block_.size.y() + cell.y()) * block_.size.x() + cell.x())];
  }

  const VoxelBlock& block_;
  std::vector<OccupancyLeaf>& leaves_;
  Eigen::Vector3i low_;
  Eigen::Vector3i high_;
};

}  // namespace

OccupancyMap to_octree(const VoxelBlock& block, double resolution) {
  OccupancyMap map;
  map.resolution = resolution;
  LeafCollector(block, map.leaves).collect(Eigen::Vector3i::Zero(), depth);
  return map;
}

}  // namespace symscene
