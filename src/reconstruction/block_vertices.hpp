#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "reconstruction/tsdf_volume.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// The edges of a block's voxels that carry a vertex, with the number of vertices before each word.
struct BlockVertices {
  static constexpr std::size_t edges = 3 * TsdfBlock::voxels;

  std::array<std::uint64_t, edges / 64> crossed{};
  std::array<std::uint16_t, edges / 64> before{};
  std::uint32_t first = 0;  ///< number of the block's first vertex
  std::uint32_t count = 0;

  /// The edge from a voxel along an axis.
  static std::size_t bit(int voxel, int axis) { return static_cast<std::size_t>(3 * voxel + axis); }
  void set(std::size_t b) { crossed[b / 64] |= std::uint64_t{1} << (b % 64); }
  void number() {
    for (std::size_t word = 0; word < crossed.size(); ++word) {
      before[word] = static_cast<std::uint16_t>(count);
      count += static_cast<std::uint32_t>(std::popcount(crossed[word]));
    }
  }
  bool is_set(std::size_t b) const { return (crossed[b / 64] >> (b % 64) & 1) != 0; }
  /// The number of the vertex on an edge.
  Index vertex(std::size_t b) const {
    const std::uint64_t lower = crossed[b / 64] & ((std::uint64_t{1} << (b % 64)) - 1);
    return first + before[b / 64] + static_cast<std::uint32_t>(std::popcount(lower));
  }
};

}  // namespace symscene
