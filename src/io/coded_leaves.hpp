#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "core/octree.hpp"
#include "symscene/core/error.hpp"

namespace symscene {

/// Names a map that cannot be written in messages.
constexpr const char* map_to_write = "occupancy map to write";

/// A leaf by its position in depth-first order.
template <class Value>
struct CodedLeaf {
  std::uint64_t begin;  ///< of its first voxel
  std::uint8_t level;
  Value value;

  std::uint64_t end() const { return begin + voxels_of(level); }
};

inline void require_resolution(double resolution) {
  if (resolution > 0.0 && std::isfinite(resolution)) return;
  throw InputError(map_to_write, "a positive resolution", fmt::format("{}", resolution));
}

inline void require_aligned(const OctreeKey& keys, int level) {
  if (level > octree_depth) {
    throw InputError(map_to_write, "levels up to 16", std::to_string(level));
  }
  const unsigned inside = (1U << level) - 1U;
  for (const std::uint16_t key : keys) {
    if ((key & inside) == 0) continue;
    throw InputError(map_to_write, "keys that are multiples of their leaf's size",
                     fmt::format("{} at level {}", key, level));
  }
}

/// Adds a leaf; a leaf that is the whole tree is added as its eight children.
template <class Value>
void add_coded(const OctreeKey& key, int level, Value value, std::vector<CodedLeaf<Value>>& coded) {
  require_aligned(key, level);
  if (level < octree_depth) {
    coded.push_back({morton_code(key), static_cast<std::uint8_t>(level), value});
    return;
  }
  constexpr int child_level = octree_depth - 1;
  for (std::uint64_t child = 0; child < 8; ++child) {
    coded.push_back({child * voxels_of(child_level), child_level, value});
  }
}

/// Sorts leaves into depth-first order. Throws InputError if two overlap.
template <class Value>
void put_in_order(std::vector<CodedLeaf<Value>>& coded) {
  const auto before = [](const auto& a, const auto& b) { return a.begin < b.begin; };
  if (!std::is_sorted(coded.begin(), coded.end(), before)) {
    std::sort(coded.begin(), coded.end(), before);
  }
  const auto overlap = [](const auto& a, const auto& b) { return a.end() > b.begin; };
  if (std::adjacent_find(coded.begin(), coded.end(), overlap) != coded.end()) {
    throw InputError(map_to_write, "leaves that do not overlap", "two that do");
  }
}

/// Removes the leaves before `end` from the front and returns them.
template <class Value>
std::span<const CodedLeaf<Value>> take_until(std::span<const CodedLeaf<Value>>& leaves,
                                             std::uint64_t end) {
  const auto first_after = std::partition_point(
      leaves.begin(), leaves.end(), [end](const auto& leaf) { return leaf.begin < end; });
  const auto count = static_cast<std::size_t>(first_after - leaves.begin());
  const auto taken = leaves.first(count);
  leaves = leaves.subspan(count);
  return taken;
}

}  // namespace symscene
