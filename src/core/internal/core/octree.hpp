#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "symscene/core/occupancy_map.hpp"

namespace symscene {

/// Puts two zero bits between the bits of `value`.
constexpr std::uint64_t spread_bits(std::uint16_t value) {
  std::uint64_t bits = value;
  bits = (bits | (bits << 16)) & 0x0000'FF00'00FFULL;
  bits = (bits | (bits << 8)) & 0x00F0'0F00'F00FULL;
  bits = (bits | (bits << 4)) & 0x0C30'C30C'30C3ULL;
  return (bits | (bits << 2)) & 0x2492'4924'9249ULL;
}

/// Takes every third bit: undoes spread_bits().
constexpr std::uint16_t gather_bits(std::uint64_t bits) {
  bits &= 0x2492'4924'9249ULL;
  bits = (bits | (bits >> 2)) & 0x0C30'C30C'30C3ULL;
  bits = (bits | (bits >> 4)) & 0x00F0'0F00'F00FULL;
  bits = (bits | (bits >> 8)) & 0x0000'FF00'00FFULL;
  return static_cast<std::uint16_t>(bits | (bits >> 16));
}

/// The position of a voxel in depth-first order, x being the lowest bit (Morton 1966).
constexpr std::uint64_t morton_code(const OctreeKey& key) {
  return spread_bits(key[0]) | (spread_bits(key[1]) << 1) | (spread_bits(key[2]) << 2);
}

/// The voxel at a position in depth-first order.
constexpr OctreeKey octree_key(std::uint64_t code) {
  return {gather_bits(code), gather_bits(code >> 1), gather_bits(code >> 2)};
}

/// The number of voxels in a cube of this level.
constexpr std::uint64_t voxels_of(int level) { return std::uint64_t{1} << (3 * level); }

/// Collects the leaves of an octree; see octree_leaves().
template <class Value, class Uniform, class MakeLeaf>
class OctreeLeafCollector {
 public:
  using Leaf = std::invoke_result_t<MakeLeaf, std::uint64_t, int, Value>;

  OctreeLeafCollector(Value nothing, const Uniform& uniform, const MakeLeaf& make_leaf)
      : nothing_(nothing), uniform_(uniform), make_leaf_(make_leaf) {}

  std::vector<Leaf> collect() {
    visit(0, octree_depth);
    return std::move(leaves_);
  }

 private:
  /// Adds the leaves of the cube. Returns its value if it is uniform.
  std::optional<Value> visit(std::uint64_t code, int level) {
    const std::size_t before = leaves_.size();
    std::optional<Value> value = uniform_(code, level);
    if (!value && level > 0) value = visit_children(code, level);
    if (value && *value != nothing_) {
      leaves_.resize(before);
      leaves_.push_back(make_leaf_(code, level, *value));
    }
    return value;
  }

  std::optional<Value> visit_children(std::uint64_t code, int level) {
    std::optional<Value> common = visit(code, level - 1);
    for (std::uint64_t child = 1; child < 8; ++child) {
      const std::optional<Value> value = visit(code + child * voxels_of(level - 1), level - 1);
      if (value != common) common.reset();
    }
    return common;
  }

  Value nothing_;
  const Uniform& uniform_;
  const MakeLeaf& make_leaf_;
  std::vector<Leaf> leaves_;
};

/// make_leaf(code, level, value) for the largest cubes of equal value, depth first; cubes with the
/// value `nothing` are left out. uniform(code, level) returns the value of the cube with an edge of
/// 2^level voxels whose first voxel is at `code`, or std::nullopt if the cube must be split; it
/// must return a value for every voxel.
template <class Value, class Uniform, class MakeLeaf>
auto octree_leaves(Value nothing, const Uniform& uniform, const MakeLeaf& make_leaf) {
  return OctreeLeafCollector<Value, Uniform, MakeLeaf>(nothing, uniform, make_leaf).collect();
}

}  // namespace symscene
