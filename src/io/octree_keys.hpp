#pragma once

#include <cstdint>

#include "core/octree.hpp"

namespace symscene {

/// The two bits of a child in OctoMap's binary format.
enum class ChildState : std::uint8_t { unknown = 0, free = 1, occupied = 2, inner = 3 };

/// The child's number: bit 0 is the half along x, bit 1 along y, bit 2 along z. `child_level` is
/// the level of the children.
constexpr OctreeKey child_key(const OctreeKey& parent, unsigned child, int child_level) {
  const auto half = [=](std::uint16_t low, unsigned axis) {
    return static_cast<std::uint16_t>(low | (((child >> axis) & 1U) << child_level));
  };
  return {half(parent[0], 0), half(parent[1], 1), half(parent[2], 2)};
}

}  // namespace symscene
