#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// Union-find over the nodes 0 … count − 1. The leader of a set is its lowest node.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : leader_(count) {
    std::iota(leader_.begin(), leader_.end(), Index{0});
  }

  Index leader(Index node) {
    while (leader_[node] != node) node = leader_[node] = leader_[leader_[node]];
    return node;
  }

  /// Joins the sets of both nodes. Returns the new leader.
  Index join(Index a, Index b) {
    const auto [low, high] = std::minmax({leader(a), leader(b)});
    leader_[high] = low;
    return low;
  }

 private:
  std::vector<Index> leader_;
};

}  // namespace symscene
