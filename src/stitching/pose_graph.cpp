#include "pose_graph.hpp"

#include <algorithm>
#include <numeric>

namespace symscene {
namespace {

/// The groups of frames that edges join (union-find).
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /// Joins two groups; whether they were different. The root of a group is its first frame.
  bool join(std::size_t a, std::size_t b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// The first frame of the largest group; of equal ones the first.
std::size_t largest_group(Groups& groups, std::size_t frames) {
  std::vector<std::size_t> sizes(frames);
  for (std::size_t i = 0; i < frames; ++i) ++sizes[groups.find(i)];
  return static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
}

}  // namespace

std::vector<std::optional<Eigen::Isometry3d>> chain_poses(std::size_t frames,
                                                          std::span<const PoseEdge> edges) {
  std::vector<std::optional<Eigen::Isometry3d>> poses(frames);
  if (frames == 0) return poses;
  std::vector<PoseEdge> ordered(edges.begin(), edges.end());
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const PoseEdge& a, const PoseEdge& b) { return a.weight > b.weight; });
  Groups groups(frames);
  std::vector<PoseEdge> tree;
  for (const PoseEdge& edge : ordered) {
    if (groups.join(edge.first, edge.second)) tree.push_back(edge);
  }
  const std::size_t root = largest_group(groups, frames);
  poses[root] = Eigen::Isometry3d::Identity();
  // A tree of n frames is covered in at most n rounds.
  for (bool grown = true; grown;) {
    grown = false;
    for (const PoseEdge& edge : tree) {
      auto& first = poses[edge.first];
      auto& second = poses[edge.second];
      if (first.has_value() == second.has_value()) continue;
      first ? second = *first* edge.T_first_second
            : first = *second * edge.T_first_second.inverse();
      grown = true;
    }
  }
  return poses;
}

}  // namespace symscene
