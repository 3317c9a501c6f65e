#include "path_joining.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "core/as_rows.hpp"
#include "measured_path.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

/// The end of a path, and the direction in which the path leaves it.
struct PathEnd {
  Index node;
  Eigen::Vector3d direction;
};

std::vector<PathEnd> path_ends(const BoundaryNodes& nodes, const std::vector<PointIndices>& paths,
                               double reach) {
  std::vector<PathEnd> ends;
  for (const PointIndices& nodes_of_path : paths) {
    if (nodes_of_path.size() < 2) continue;
    const MeasuredPath path(nodes, nodes_of_path);
    ends.push_back({nodes_of_path.front(), path.direction_at_start(reach)});
    ends.push_back({nodes_of_path.back(), path.direction_at_end(reach)});
  }
  return ends;
}

bool is_continued(const BoundaryNodes& nodes, const PathEnd& a, const PathEnd& b,
                  double max_angle) {
  const Eigen::Vector3d gap = nodes[b.node].position - nodes[a.node].position;
  return angle_between(a.direction, -b.direction) <= max_angle &&
         angle_between(a.direction, gap) <= max_angle &&
         angle_between(-b.direction, gap) <= max_angle;
}

/// Pairs of ends that belong together, the nearest first.
std::vector<std::pair<Index, Index>> ends_to_join(const BoundaryNodes& nodes,
                                                  const std::vector<PathEnd>& ends,
                                                  const EdgeCurveOptions& options) {
  const Points positions = as_rows(ends, [&](const PathEnd& end) -> Eigen::Vector3f {
    return nodes[end.node].position.cast<float>();
  });
  const NeighborLists near = radius_neighbors(positions, static_cast<float>(options.link_distance));
  std::vector<std::tuple<float, Index, Index>> pairs;
  for (Index a = 0; a < near.size(); ++a) {
    for (const Index b : near.of(a)) {
      if (a < b && is_continued(nodes, ends[a], ends[b], options.corner_angle))
        pairs.emplace_back((positions.row(a) - positions.row(b)).norm(), ends[a].node,
                           ends[b].node);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<std::pair<Index, Index>> sorted;
  for (const auto& [distance, a, b] : pairs) sorted.emplace_back(a, b);
  return sorted;
}

/// Paths that grow by joining; each is found by the nodes at its ends.
class PathJoiner {
 public:
  PathJoiner(std::size_t nodes, std::vector<PointIndices> paths)
      : paths_(std::move(paths)), path_at_(nodes, none) {
    for (std::size_t p = 0; p < paths_.size(); ++p) set_ends(p);
  }

  /// Joins the paths that end in `a` and `b`, if both are ends of different paths still.
  void join(Index a, Index b) {
    const std::size_t first = path_at_[a], second = path_at_[b];
    if (first == none || second == none || first == second) return;
    PointIndices& head = paths_[first];
    PointIndices& tail = paths_[second];
    if (head.back() != a) std::reverse(head.begin(), head.end());
    if (tail.front() != b) std::reverse(tail.begin(), tail.end());
    path_at_[a] = path_at_[b] = none;
    head.insert(head.end(), tail.begin(), tail.end());
    tail.clear();
    set_ends(first);
  }

  /// The paths that are left.
  std::vector<PointIndices> paths() && {
    std::erase_if(paths_, [](const PointIndices& path) { return path.empty(); });
    return std::move(paths_);
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  void set_ends(std::size_t path) {
    if (paths_[path].size() < 2) return;
    path_at_[paths_[path].front()] = path;
    path_at_[paths_[path].back()] = path;
  }

  std::vector<PointIndices> paths_;
  std::vector<std::size_t> path_at_;  ///< per node, the path that ends in it
};

}  // namespace

std::vector<PointIndices> joined_paths(const BoundaryNodes& nodes, std::vector<PointIndices> paths,
                                       const EdgeCurveOptions& options) {
  const std::vector<PathEnd> ends = path_ends(nodes, paths, options.tangent_radius);
  PathJoiner joiner(nodes.size(), std::move(paths));
  for (const auto& [a, b] : ends_to_join(nodes, ends, options)) joiner.join(a, b);
  return std::move(joiner).paths();
}

}  // namespace symscene
