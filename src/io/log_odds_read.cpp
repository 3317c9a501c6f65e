#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "file_end.hpp"
#include "io/atomic_file.hpp"
#include "octomap_header.hpp"
#include "octomap_log_odds.hpp"
#include "octree_keys.hpp"
#include "scalar.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr std::size_t node_bytes = 5;

/// Walks the tree in the file's order, depth first, with a stack as deep as the tree.
class LogOddsReader {
 public:
  LogOddsReader(std::string_view body, std::string name) : body_(body), name_(std::move(name)) {}

  std::vector<LogOddsLeaf> read() {
    enter(OctreeKey{}, octree_depth);
    while (depth_ > 0) {
      Inner& node = stack_[depth_ - 1];
      if (node.children == 0) {
        --depth_;
        continue;
      }
      const auto child = static_cast<unsigned>(std::countr_zero(node.children));
      node.children &= node.children - 1U;
      const int level = octree_depth - static_cast<int>(depth_);
      enter(child_key(node.key, child, level), level);
    }
    return std::move(leaves_);
  }

  std::uint64_t nodes() const { return nodes_; }
  /// What is left behind the tree.
  std::string_view rest() const { return body_; }

 private:
  struct Inner {
    OctreeKey key{};
    unsigned children = 0;  ///< children still to be read, one bit each
  };

  void enter(const OctreeKey& key, int level) {
    if (body_.size() < node_bytes) throw InputError(name_, "more nodes", "the end of the file");
    const auto log_odds = load<float>(body_.data());
    const unsigned children = load<std::uint8_t>(body_.data() + sizeof(float));
    body_.remove_prefix(node_bytes);
    ++nodes_;
    if (!std::isfinite(log_odds)) {
      throw InputError(name_, "finite log-odds", fmt::format("{}", log_odds));
    }
    if (children == 0) {
      leaves_.push_back({key, static_cast<std::uint8_t>(level), log_odds});
    } else if (level == 0) {
      throw InputError(name_, "a tree of depth 16", "a voxel with children");
    } else {
      stack_[depth_++] = {key, children};
    }
  }

  std::string_view body_;
  std::string name_;
  std::array<Inner, octree_depth> stack_{};
  std::size_t depth_ = 0;
  std::uint64_t nodes_ = 0;
  std::vector<LogOddsLeaf> leaves_;
};

}  // namespace

LogOddsMap parse_log_odds(std::string_view bytes, const std::string& name) {
  const OctomapHeader header =
      parse_octomap_header(bytes, "# Octomap OcTree file", "an OctoMap file (.ot)", name);
  LogOddsMap map;
  map.resolution = header.resolution;
  if (header.size == 0) return map;
  LogOddsReader reader(bytes, name);
  map.leaves = reader.read();
  require_nodes(header, reader.nodes(), name);
  require_end(reader.rest(), name);
  return map;
}

LogOddsMap read_log_odds(const std::filesystem::path& path) {
  return parse_log_odds(read_file(path), path.string());
}

}  // namespace symscene
