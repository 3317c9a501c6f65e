#pragma once

#include <cstddef>
#include <vector>

namespace symscene {

/// An undirected graph whose adjacent nodes exclude each other.
struct ConflictGraph {
  std::vector<double> weights;                      ///< of the nodes, at least 0
  std::vector<std::vector<std::size_t>> adjacency;  ///< of each node, ascending
};

/// A maximum-weight independent set, as one flag per node. Connected components of up to
/// `max_exact` nodes are solved exactly by branch and bound, larger ones by local search, whose set
/// is independent but not always of maximum weight.
std::vector<bool> max_weight_independent_set(const ConflictGraph& graph, std::size_t max_exact);

}  // namespace symscene
