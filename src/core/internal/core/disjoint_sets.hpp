#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "symscene/core/types.hpp"

namespace symscene {

/// Disjoint sets of nodes, each led by its lowest.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : leader_(count) {
    std::iota(leader_.begin(), leader_.end(), Index{0});
  }

  Index leader(Index node) {
    while (leader_[node] != node) node = leader_[node] = leader_[leader_[node]];
    return node;
  }

  /// Makes the sets of both nodes one; its leader.
  Index join(Index a, Index b) {
    const auto [low, high] = std::minmax({leader(a), leader(b)});
    leader_[high] = low;
    return low;
  }

 private:
  std::vector<Index> leader_;
};

}  // namespace symscene
