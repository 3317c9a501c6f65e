#include <algorithm>
#include <array>
#include <bit>

#include "file_end.hpp"
#include "io/atomic_file.hpp"
#include "octomap_header.hpp"
#include "octree_keys.hpp"
#include "scalar.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/octomap.hpp"

namespace symscene {
namespace {

/// Walks the tree in the file's order, depth first, with a stack as deep as the tree.
class TreeReader {
 public:
  TreeReader(std::string_view body, std::string name) : body_(body), name_(std::move(name)) {}

  /// Returns the leaves and counts the nodes.
  std::vector<OccupancyLeaf> read(std::uint64_t expected_nodes) {
    leaves_.reserve(std::min<std::uint64_t>(expected_nodes, 4 * body_.size()));
    enter(OctreeKey{});
    while (depth_ > 0) {
      Node& node = stack_[depth_ - 1];
      if (node.inner == 0) {
        add_leaves(node, node.leaves);
        --depth_;
      } else {
        const unsigned child = first_bit(node.inner);
        add_leaves(node, node.leaves & ((1U << child) - 1U));
        node.leaves &= ~((1U << child) - 1U);
        node.inner &= node.inner - 1U;
        enter(child_key(node.key, child / 2, child_level()));
      }
    }
    nodes_ += leaves_.size();
    return std::move(leaves_);
  }

  std::uint64_t nodes() const { return nodes_; }
  /// What is left behind the tree.
  std::string_view rest() const { return body_; }

 private:
  /// The children of a node that are still to be read, one mask bit per child, at the even bits.
  struct Node {
    OctreeKey key{};
    unsigned states = 0;
    unsigned leaves = 0;
    unsigned inner = 0;
  };

  int child_level() const { return octree_depth - static_cast<int>(depth_); }

  static unsigned first_bit(unsigned mask) { return static_cast<unsigned>(std::countr_zero(mask)); }

  void add_leaves(const Node& node, unsigned mask) {
    std::array<OccupancyLeaf, 8> added;
    std::size_t count = 0;
    const int level = child_level();
    for (; mask != 0; mask &= mask - 1U) {
      const unsigned bit = first_bit(mask);
      const bool occupied = ((node.states >> bit) & 2U) != 0;
      added[count++] = {child_key(node.key, bit / 2, level), static_cast<std::uint8_t>(level),
                        occupied ? VoxelState::occupied : VoxelState::free};
    }
    leaves_.insert(leaves_.end(), added.begin(), added.begin() + count);
  }

  void enter(const OctreeKey& key) {
    if (depth_ == octree_depth) {
      throw InputError(name_, "a tree of depth 16", "a voxel with children");
    }
    if (body_.size() < 2) throw InputError(name_, "more nodes", "the end of the file");
    const unsigned states = load<std::uint16_t>(body_.data());
    constexpr unsigned even_bits = 0x5555;
    const unsigned low = states & even_bits;
    const unsigned high = (states >> 1) & even_bits;
    stack_[depth_++] = {key, states, low ^ high, low & high};
    body_.remove_prefix(2);
    ++nodes_;
  }

  std::string_view body_;
  std::string name_;
  std::array<Node, octree_depth> stack_{};
  std::size_t depth_ = 0;
  std::uint64_t nodes_ = 0;  ///< inner nodes only, until all are read
  std::vector<OccupancyLeaf> leaves_;
};

}  // namespace

OccupancyMap parse_octomap(std::string_view bytes, const std::string& name) {
  const OctomapHeader header =
      parse_octomap_header(bytes, binary_octomap_line, "an OctoMap binary file (.bt)", name);
  OccupancyMap map;
  map.resolution = header.resolution;
  if (header.size == 0) return map;
  TreeReader reader(bytes, name);
  map.leaves = reader.read(header.size);
  require_nodes(header, reader.nodes(), name);
  require_end(reader.rest(), name);
  return map;
}

OccupancyMap read_octomap(const std::filesystem::path& path) {
  return parse_octomap(read_file(path), path.string());
}

}  // namespace symscene
