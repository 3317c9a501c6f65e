#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "io/octree_keys.hpp"
#include "io/scalar.hpp"
#include "io/text.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/atomic_file.hpp"
#include "symscene/io/octomap.hpp"

namespace symscene {
namespace {

constexpr std::string_view first_line = "# Octomap OcTree binary file";

struct OctomapHeader {
  std::uint64_t size = 0;  ///< nodes, leaves too
  double resolution = 0.0;
};

OctomapHeader parse_header(std::string_view& rest, const std::string& name) {
  const std::string_view begin = rest.substr(0, rest.find('\n'));
  if (next_line(rest) != first_line) {
    throw InputError(name, "an OctoMap binary file (.bt)", in_quotes(begin));
  }
  OctomapHeader header;
  std::optional<std::uint64_t> size;
  while (true) {
    const auto line = next_line(rest);
    if (!line) throw InputError(name, "a line \"data\"", "the end of the file");
    const auto words = words_of(*line);
    if (words.empty() || words[0].starts_with('#')) continue;
    if (words[0] == "data") break;
    const std::string_view value = words.size() > 1 ? words[1] : "";
    if (words[0] == "id" && value != "OcTree")
      throw InputError(name, "id OcTree", in_quotes(*line));
    if (words[0] == "size") size = to_number<std::uint64_t>(value);
    if (words[0] == "res") header.resolution = to_number<double>(value).value_or(0.0);
  }
  if (!size) throw InputError(name, "a line size N", "none");
  if (!(header.resolution > 0.0 && std::isfinite(header.resolution))) {
    throw InputError(name, "a positive resolution after res", fmt::format("{}", header.resolution));
  }
  header.size = *size;
  return header;
}

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
      if (node.next_child == 8) {
        --depth_;
        continue;
      }
      const unsigned child = node.next_child++;
      visit(static_cast<ChildState>((node.states >> (2 * child)) & 3U),
            child_key(node.key, child, child_level()));
    }
    return std::move(leaves_);
  }

  std::uint64_t nodes() const { return nodes_; }

 private:
  struct Node {
    OctreeKey key;
    std::uint16_t states;  ///< two bits a child
    unsigned next_child;
  };

  int child_level() const { return octree_depth - static_cast<int>(depth_); }

  void visit(ChildState state, const OctreeKey& key) {
    if (state == ChildState::unknown) return;
    if (state == ChildState::inner) return enter(key);
    ++nodes_;
    leaves_.push_back({key, static_cast<std::uint8_t>(child_level()),
                       state == ChildState::free ? VoxelState::free : VoxelState::occupied});
  }

  void enter(const OctreeKey& key) {
    if (depth_ == octree_depth) {
      throw InputError(name_, "a tree of depth 16", "a voxel with children");
    }
    if (body_.size() < 2) {
      throw InputError(name_, "more nodes", fmt::format("the end of the file after {}", nodes_));
    }
    stack_[depth_++] = {key, load<std::uint16_t>(body_.data()), 0};
    body_.remove_prefix(2);
    ++nodes_;
  }

  std::string_view body_;
  std::string name_;
  std::array<Node, octree_depth> stack_{};
  std::size_t depth_ = 0;
  std::uint64_t nodes_ = 0;
  std::vector<OccupancyLeaf> leaves_;
};

}  // namespace

OccupancyMap parse_octomap(std::string_view bytes, const std::string& name) {
  const OctomapHeader header = parse_header(bytes, name);
  OccupancyMap map;
  map.resolution = header.resolution;
  if (header.size == 0) return map;
  TreeReader reader(bytes, name);
  map.leaves = reader.read(header.size);
  if (reader.nodes() == header.size) return map;
  throw InputError(name, fmt::format("{} nodes, as its header says", header.size),
                   std::to_string(reader.nodes()));
}

OccupancyMap read_octomap(const std::filesystem::path& path) {
  return parse_octomap(read_file(path), path.string());
}

}  // namespace symscene
