#include "ordered_paths.hpp"

#include <algorithm>
#include <tuple>

#include "core/disjoint_sets.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

struct Link {
  Index to;
  double length;  ///< [m]
};
using Forest = std::vector<std::vector<Link>>;

/// Kruskal's algorithm; ties go to the lower points.
Forest spanning_forest(const Points& points, double link_distance) {
  std::vector<std::tuple<double, Index, Index>> links;
  const NeighborLists near = radius_neighbors(points, static_cast<float>(link_distance));
  for (Index a = 0; a < near.size(); ++a) {
    for (const Index b : near.of(a)) {
      if (a < b) links.emplace_back(double{(points.row(a) - points.row(b)).norm()}, a, b);
    }
  }
  std::sort(links.begin(), links.end());
  Forest forest(near.size());
  DisjointSets trees(near.size());
  for (const auto& [length, a, b] : links) {
    if (trees.leader(a) == trees.leader(b)) continue;
    trees.join(a, b);
    forest[a].push_back({b, length});
    forest[b].push_back({a, length});
  }
  return forest;
}

/// Takes the longest paths out of the trees of a forest.
class PathSplitter {
 public:
  explicit PathSplitter(const Forest& forest)
      : forest_(forest), used_(forest.size(), false), parent_(forest.size()) {}

  /// The longest path of the tree of `start`, which is then used.
  PointIndices take_longest_path(Index start) {
    const Index end = farthest(start);
    PointIndices path;
    for (Index node = farthest(end); node != end; node = parent_[node]) path.push_back(node);
    path.push_back(end);
    for (const Index node : path) used_[node] = true;
    return path;
  }

  bool is_used(Index node) const { return used_[node]; }

 private:
  /// The unused node farthest from `start` along the tree, whose parents then lead back to it.
  Index farthest(Index start) {
    std::vector<std::pair<Index, double>> open{{start, 0.0}};
    parent_[start] = start;
    std::pair<double, Index> best{0.0, start};
    for (std::size_t next = 0; next < open.size(); ++next) {
      const auto [node, distance] = open[next];
      if (distance > best.first) best = {distance, node};
      for (const Link& link : forest_[node]) {
        if (used_[link.to] || link.to == parent_[node]) continue;
        parent_[link.to] = node;
        open.emplace_back(link.to, distance + link.length);
      }
    }
    return best.second;
  }

  const Forest& forest_;
  std::vector<bool> used_;
  std::vector<Index> parent_;
};

}  // namespace

std::vector<PointIndices> ordered_paths(const Points& points, double link_distance) {
  const Forest forest = spanning_forest(points, link_distance);
  PathSplitter splitter(forest);
  std::vector<PointIndices> paths;
  for (Index root = 0; root < forest.size(); ++root) {
    while (!splitter.is_used(root)) paths.push_back(splitter.take_longest_path(root));
  }
  return paths;
}

}  // namespace symscene
