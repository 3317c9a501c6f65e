#include <array>
#include <span>

#include "coded_leaves.hpp"
#include "io/atomic_file.hpp"
#include "octomap_header.hpp"
#include "octree_keys.hpp"
#include "scalar.hpp"
#include "symscene/io/octomap.hpp"

namespace symscene {
namespace {

using StateLeaf = CodedLeaf<ChildState>;

/// The leaves in depth-first order.
std::vector<StateLeaf> coded_leaves(const OccupancyMap& map) {
  std::vector<StateLeaf> coded;
  coded.reserve(map.leaves.size());
  for (const OccupancyLeaf& leaf : map.leaves) {
    if (leaf.state == VoxelState::never_seen) continue;
    const bool free = leaf.state == VoxelState::free;
    add_coded(leaf.key, leaf.level, free ? ChildState::free : ChildState::occupied, coded);
  }
  put_in_order(coded);
  return coded;
}

/// Appends the inner nodes of the tree over sorted leaves, two bytes each, depth first.
class TreeWriter {
 public:
  /// The tree of `leaves`, none of which is the node itself.
  void write(std::span<const StateLeaf> leaves, std::uint64_t begin, int level) {
    ++nodes_;
    std::array<std::span<const StateLeaf>, 8> children;
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
  static ChildState state_of(std::span<const StateLeaf> leaves, int level) {
    if (leaves.empty()) return ChildState::unknown;
    return leaves.front().level == level ? leaves.front().value : ChildState::inner;
  }

  std::uint64_t nodes_ = 0;
  std::string body_;
};

}  // namespace

std::string format_octomap(const OccupancyMap& map) {
  require_resolution(map.resolution);
  const std::vector<StateLeaf> leaves = coded_leaves(map);
  TreeWriter writer;
  if (!leaves.empty()) writer.write(leaves, 0, octree_depth);
  return format_octomap_header({writer.nodes(), map.resolution}, binary_octomap_line) +
         writer.body();
}

}  // namespace symscene
