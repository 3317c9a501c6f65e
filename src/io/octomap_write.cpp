#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "io/octree_keys.hpp"
#include "io/scalar.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/atomic_file.hpp"
#include "symscene/io/octomap.hpp"

namespace symscene {
namespace {

constexpr const char* where = "occupancy map to write";

/// A leaf by its place in depth-first order.
struct CodedLeaf {
  std::uint64_t begin;  ///< of its first voxel
  std::uint8_t level;
  ChildState state;

  std::uint64_t end() const { return begin + voxels_of(level); }
};

void require_aligned(const OccupancyLeaf& leaf) {
  if (leaf.level > octree_depth) {
    throw InputError(where, "levels up to 16", std::to_string(leaf.level));
  }
  const unsigned inside = (1U << leaf.level) - 1U;
  for (const std::uint16_t key : leaf.key) {
    if ((key & inside) == 0) continue;
    throw InputError(where, "keys that are multiples of their leaf's size",
                     fmt::format("{} at level {}", key, leaf.level));
  }
}

void add_coded(const OccupancyLeaf& leaf, std::vector<CodedLeaf>& coded) {
  if (leaf.state == VoxelState::never_seen) return;
  require_aligned(leaf);
  const auto state = leaf.state == VoxelState::free ? ChildState::free : ChildState::occupied;
  if (leaf.level < octree_depth) {
    coded.push_back({morton_code(leaf.key), leaf.level, state});
    return;
  }
  constexpr int level = octree_depth - 1;
  for (std::uint64_t child = 0; child < 8; ++child) {
    coded.push_back({child * voxels_of(level), level, state});
  }
}

/// The leaves in depth-first order.
std::vector<CodedLeaf> coded_leaves(const OccupancyMap& map) {
  std::vector<CodedLeaf> coded;
  coded.reserve(map.leaves.size());
  for (const OccupancyLeaf& leaf : map.leaves) add_coded(leaf, coded);
  const auto before = [](const CodedLeaf& a, const CodedLeaf& b) { return a.begin < b.begin; };
  if (!std::is_sorted(coded.begin(), coded.end(), before)) {
    std::sort(coded.begin(), coded.end(), before);
  }
  const auto overlap = [](const CodedLeaf& a, const CodedLeaf& b) { return a.end() > b.begin; };
  if (std::adjacent_find(coded.begin(), coded.end(), overlap) != coded.end()) {
    throw InputError(where, "leaves that do not overlap", "two that do");
  }
  return coded;
}

/// Appends the inner nodes of the tree over sorted leaves, two bytes each, depth first.
class TreeWriter {
 public:
  /// The tree of `leaves`, none of which is the node itself.
  void write(std::span<const CodedLeaf> leaves, std::uint64_t begin, int level) {
    ++nodes_;
    std::array<std::span<const CodedLeaf>, 8> children;
    std::uint16_t states = 0;
    for (unsigned child = 0; child < 8; ++child) {
      children[child] = take_until(leaves, begin + (child + 1) * voxels_of(level - 1));
      const ChildState state = state_of(children[child], level - 1);
      if (state == ChildState::free || state == ChildState::occupied) ++nodes_;
      if (state != ChildState::inner) children[child] = {};
      states = static_cast<std::uint16_t>(states | (static_cast<unsigned>(state) << (2 * child)));
    }
    append_scalar(body_, states);
    for (unsigned child = 0; child < 8; ++child) {
      if (children[child].empty()) continue;
      write(children[child], begin + child * voxels_of(level - 1), level - 1);
    }
  }

  std::uint64_t nodes() const { return nodes_; }
  const std::string& body() const { return body_; }

 private:
  /// Takes the leaves before `end` off the front.
  static std::span<const CodedLeaf> take_until(std::span<const CodedLeaf>& leaves,
                                               std::uint64_t end) {
    const auto first_after = std::partition_point(
        leaves.begin(), leaves.end(), [end](const CodedLeaf& leaf) { return leaf.begin < end; });
    const auto count = static_cast<std::size_t>(first_after - leaves.begin());
    const auto taken = leaves.first(count);
    leaves = leaves.subspan(count);
    return taken;
  }

  static ChildState state_of(std::span<const CodedLeaf> leaves, int level) {
    if (leaves.empty()) return ChildState::unknown;
    return leaves.front().level == level ? leaves.front().state : ChildState::inner;
  }

  std::uint64_t nodes_ = 0;
  std::string body_;
};

}  // namespace

std::string format_octomap(const OccupancyMap& map) {
  if (!(map.resolution > 0.0 && std::isfinite(map.resolution))) {
    throw InputError(where, "a positive resolution", fmt::format("{}", map.resolution));
  }
  const std::vector<CodedLeaf> leaves = coded_leaves(map);
  TreeWriter writer;
  if (!leaves.empty()) writer.write(leaves, 0, octree_depth);
  return fmt::format("# Octomap OcTree binary file\nid OcTree\nsize {}\nres {}\ndata\n",
                     writer.nodes(), map.resolution) +
         writer.body();
}

void write_octomap(const std::filesystem::path& path, const OccupancyMap& map) {
  write_file_atomically(path, format_octomap(map));
}

}  // namespace symscene
