#pragma once

#include <cstdint>

#include "occupancy_brick.hpp"
#include "symscene/core/occupancy_map.hpp"

namespace symscene {

/// The position of a brick in the tree: 10 bits along each axis, x lowest.
using BrickKey = std::uint32_t;
constexpr BrickKey no_brick = ~BrickKey{0};

inline OctreeKey first_voxel(BrickKey brick) {
  const auto key = [&](unsigned shift) {
    return static_cast<std::uint16_t>(((brick >> shift) & 1023U) << brick_level);
  };
  return {key(0), key(10), key(20)};
}

inline BrickKey brick_of(const OctreeKey& key) {
  const auto part = [&](unsigned axis) { return BrickKey{key[axis]} >> unsigned{brick_level}; };
  return part(0) | (part(1) << 10U) | (part(2) << 20U);
}

}  // namespace symscene
