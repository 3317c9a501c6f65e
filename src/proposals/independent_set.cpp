#include "proposals/independent_set.hpp"

#include <algorithm>

namespace symscene {
namespace {

using Nodes = std::vector<std::size_t>;

/// The nodes of each connected component, ascending.
std::vector<Nodes> components_of(const ConflictGraph& graph) {
  std::vector<bool> visited(graph.weights.size(), false);
  std::vector<Nodes> components;
  for (std::size_t start = 0; start < visited.size(); ++start) {
    if (visited[start]) continue;
    Nodes component{start};
    visited[start] = true;
    for (std::size_t next = 0; next < component.size(); ++next) {
      for (const std::size_t neighbor : graph.adjacency[component[next]]) {
        if (visited[neighbor]) continue;
        visited[neighbor] = true;
        component.push_back(neighbor);
      }
    }
    std::sort(component.begin(), component.end());
    components.push_back(std::move(component));
  }
  return components;
}

/// Branch and bound: each node is tried in and out while the remaining weight could still improve
/// on the best set.
class ExactSearch {
 public:
  ExactSearch(const ConflictGraph& graph, const Nodes& component)
      : graph_(graph), component_(component) {}

  Nodes run() {
    double remaining = 0.0;
    for (const std::size_t node : component_) remaining += graph_.weights[node];
    extend(0, 0.0, remaining);
    return best_;
  }

 private:
  void extend(std::size_t next, double weight, double remaining) {
    if (weight > best_weight_) {
      best_weight_ = weight;
      best_ = chosen_;
    }
    if (next == component_.size() || weight + remaining <= best_weight_) return;
    const std::size_t node = component_[next];
    const double node_weight = graph_.weights[node];
    const Nodes& neighbors = graph_.adjacency[node];
    const bool is_free = std::none_of(chosen_.begin(), chosen_.end(), [&](std::size_t other) {
      return std::binary_search(neighbors.begin(), neighbors.end(), other);
    });
    if (is_free) {
      chosen_.push_back(node);
      extend(next + 1, weight + node_weight, remaining - node_weight);
      chosen_.pop_back();
    }
    extend(next + 1, weight, remaining - node_weight);
  }

  const ConflictGraph& graph_;
  const Nodes& component_;
  Nodes chosen_;
  Nodes best_;
  double best_weight_ = -1.0;
};

/// Greedy by falling weight, then swaps while one gains: a node for its chosen neighbours, or a
/// chosen node for the neighbours that only it excludes.
class LocalSearch {
 public:
  LocalSearch(const ConflictGraph& graph, Nodes component)
      : graph_(graph), component_(std::move(component)), is_chosen_(graph.weights.size(), false) {
    std::stable_sort(component_.begin(), component_.end(), [&](std::size_t a, std::size_t b) {
      return graph_.weights[a] > graph_.weights[b];
    });
  }

  Nodes run() {
    for (const std::size_t node : component_) {
      if (chosen_neighbors(node).empty()) is_chosen_[node] = true;
    }
    for (bool gained = true; gained;) {
      gained = false;
      for (const std::size_t node : component_)
        gained = (is_chosen_[node] ? swap_out(node) : swap_in(node)) || gained;
    }
    Nodes chosen;
    std::copy_if(component_.begin(), component_.end(), std::back_inserter(chosen),
                 [&](std::size_t node) { return is_chosen_[node]; });
    return chosen;
  }

 private:
  static constexpr double least_gain = 1e-9;  // rounding alone must not count as one

  Nodes chosen_neighbors(std::size_t node) const {
    Nodes chosen;
    for (const std::size_t neighbor : graph_.adjacency[node]) {
      if (is_chosen_[neighbor]) chosen.push_back(neighbor);
    }
    return chosen;
  }

  bool swap_in(std::size_t node) {
    const Nodes neighbors = chosen_neighbors(node);
    double gain = graph_.weights[node];
    for (const std::size_t neighbor : neighbors) gain -= graph_.weights[neighbor];
    if (gain <= least_gain) return false;
    for (const std::size_t neighbor : neighbors) is_chosen_[neighbor] = false;
    is_chosen_[node] = true;
    return true;
  }

  bool swap_out(std::size_t node) {
    is_chosen_[node] = false;
    double gain = -graph_.weights[node];
    Nodes added;
    for (const std::size_t other : component_) {
      const Nodes& neighbors = graph_.adjacency[other];
      if (!std::binary_search(neighbors.begin(), neighbors.end(), node)) continue;
      if (!chosen_neighbors(other).empty()) continue;
      is_chosen_[other] = true;
      added.push_back(other);
      gain += graph_.weights[other];
    }
    if (gain > least_gain) return true;
    for (const std::size_t other : added) is_chosen_[other] = false;
    is_chosen_[node] = true;
    return false;
  }

  const ConflictGraph& graph_;
  Nodes component_;
  std::vector<bool> is_chosen_;
};

}  // namespace

std::vector<bool> max_weight_independent_set(const ConflictGraph& graph, std::size_t max_exact) {
  std::vector<bool> chosen(graph.weights.size(), false);
  for (const Nodes& component : components_of(graph)) {
    const Nodes best = component.size() <= max_exact ? ExactSearch(graph, component).run()
                                                     : LocalSearch(graph, component).run();
    for (const std::size_t node : best) chosen[node] = true;
  }
  return chosen;
}

}  // namespace symscene
