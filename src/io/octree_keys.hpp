#pragma once

#include <array>
#include <cstdint>

namespace symscene {

/// OctoMap's trees are 16 levels deep; the root is at level 16, a voxel at level 0.
constexpr int octree_depth = 16;

/// What the two bits of a child say in OctoMap's binary format.
enum class ChildState : std::uint8_t { unknown = 0, free = 1, occupied = 2, inner = 3 };

using OctreeKey = std::array<std::uint16_t, 3>;

/// The child's number: bit 0 is the half along x, bit 1 along y, bit 2 along z. `child_level` is
/// the level of the children.
constexpr OctreeKey child_key(const OctreeKey& parent, unsigned child, int child_level) {
  const auto half = [=](std::uint16_t low, unsigned axis) {
    return static_cast<std::uint16_t>(low | (((child >> axis) & 1U) << child_level));
  };
  return {half(parent[0], 0), half(parent[1], 1), half(parent[2], 2)};
}

/// Puts two zero bits between the bits of `value`.
constexpr std::uint64_t spread_bits(std::uint16_t value) {
  std::uint64_t bits = value;
  bits = (bits | (bits << 16)) & 0x0000'FF00'00FFULL;
  bits = (bits | (bits << 8)) & 0x00F0'0F00'F00FULL;
  bits = (bits | (bits << 4)) & 0x0C30'C30C'30C3ULL;
  return (bits | (bits << 2)) & 0x2492'4924'9249ULL;
}

/// The place of a voxel in depth-first order.
constexpr std::uint64_t morton_code(const OctreeKey& key) {
  return spread_bits(key[0]) | (spread_bits(key[1]) << 1) | (spread_bits(key[2]) << 2);
}

/// The number of voxels in a cube of this level.
constexpr std::uint64_t voxels_of(int level) { return std::uint64_t{1} << (3 * level); }

}  // namespace symscene
