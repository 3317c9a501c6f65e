#include <algorithm>
#include <array>
#include <limits>

#include "coded_leaves.hpp"
#include "io/atomic_file.hpp"
#include "octomap_header.hpp"
#include "octomap_log_odds.hpp"
#include "scalar.hpp"

namespace symscene {
namespace {

using FloatLeaf = CodedLeaf<float>;

/// The leaves in depth-first order.
std::vector<FloatLeaf> coded_leaves(const LogOddsMap& map) {
  std::vector<FloatLeaf> coded;
  coded.reserve(map.leaves.size());
  for (const LogOddsLeaf& leaf : map.leaves) {
    if (!std::isfinite(leaf.log_odds)) {
      throw InputError(map_to_write, "finite log-odds", fmt::format("{}", leaf.log_odds));
    }
    add_coded(leaf.key, leaf.level, leaf.log_odds, coded);
  }
  put_in_order(coded);
  return coded;
}

/// Appends all nodes of the tree over sorted leaves, five bytes each, depth first.
class LogOddsWriter {
 public:
  /// The tree of `leaves`; returns the greatest log-odds in it.
  float write(std::span<const FloatLeaf> leaves, std::uint64_t begin, int level) {
    ++nodes_;
    const std::size_t place = body_.size();
    body_.append(sizeof(float) + 1, '\0');
    const bool is_leaf = leaves.front().level == level;
    unsigned children = 0;
    float greatest = is_leaf ? leaves.front().value : -std::numeric_limits<float>::infinity();
    for (unsigned child = 0; child < 8 && !is_leaf; ++child) {
      const std::uint64_t child_begin = begin + child * voxels_of(level - 1);
      const auto inside = take_until(leaves, child_begin + voxels_of(level - 1));
      if (inside.empty()) continue;
      children |= 1U << child;
      greatest = std::max(greatest, write(inside, child_begin, level - 1));
    }
    std::string node;
    append_scalar(node, greatest);
    append_scalar(node, static_cast<std::uint8_t>(children));
    body_.replace(place, node.size(), node);
    return greatest;
  }

  std::uint64_t nodes() const { return nodes_; }
  const std::string& body() const { return body_; }

 private:
  std::uint64_t nodes_ = 0;
  std::string body_;
};

}  // namespace

std::string format_log_odds(const LogOddsMap& map) {
  require_resolution(map.resolution);
  const std::vector<FloatLeaf> leaves = coded_leaves(map);
  LogOddsWriter writer;
  if (!leaves.empty()) writer.write(leaves, 0, octree_depth);
  return format_octomap_header({writer.nodes(), map.resolution}, "# Octomap OcTree file") +
         writer.body();
}

void write_log_odds(const std::filesystem::path& path, const LogOddsMap& map) {
  write_file_atomically(path, format_log_odds(map));
}

}  // namespace symscene
