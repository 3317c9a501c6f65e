#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// Maps the coordinates of blocks of voxels to slots: a directory of chunks of 32³ blocks, so that
/// a look-up is two loads. Blocks have coordinates in [−1024, 1024); slots are numbered in the
/// order of insertion.
class BlockIndex {
 public:
  static constexpr std::int32_t none = -1;
  static constexpr int reach = 1024;  ///< blocks in each direction from the origin

  BlockIndex();

  /// Whether the index can hold a block at these coordinates.
  static bool in_reach(const Eigen::Vector3i& block) {
    return (block.array() >= -reach).all() && (block.array() < reach).all();
  }

  /// The slot of a block, or `none`; any coordinates are allowed.
  std::int32_t find(int x, int y, int z) const {
    const auto bx = static_cast<std::uint32_t>(x + reach);
    const auto by = static_cast<std::uint32_t>(y + reach);
    const auto bz = static_cast<std::uint32_t>(z + reach);
    if ((bx | by | bz) >= 2 * reach) return none;
    const std::int32_t chunk = directory_[((bz >> 5) << 12) | ((by >> 5) << 6) | (bx >> 5)];
    if (chunk == none) return none;
    return slots_[static_cast<std::size_t>(chunk) * chunk_size + place(bx, by, bz)];
  }
  std::int32_t find(const Eigen::Vector3i& block) const {
    return find(block.x(), block.y(), block.z());
  }

  /// The slot of a block in reach; it is added if it has none.
  std::int32_t insert(const Eigen::Vector3i& block);

  /// The coordinates of the blocks by slot.
  const std::vector<Eigen::Vector3i>& blocks() const { return blocks_; }
  std::size_t size() const { return blocks_.size(); }

  /// Memory in use. [bytes]
  std::size_t bytes() const;

 private:
  static constexpr std::size_t chunk_size = 32 * 32 * 32;

  static std::size_t place(std::uint32_t bx, std::uint32_t by, std::uint32_t bz) {
    return ((bz & 31U) << 10) | ((by & 31U) << 5) | (bx & 31U);
  }

  std::vector<std::int32_t> directory_;
  std::vector<std::int32_t> slots_;
  std::vector<Eigen::Vector3i> blocks_;
};

}  // namespace symscene
