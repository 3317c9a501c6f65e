#include "graph_cut.hpp"

#include <algorithm>
#include <limits>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using Capacity = std::int32_t;

constexpr float fixed_point = 65536.0F;
constexpr float max_weight = 8192.0F;
constexpr Index no_arc = std::numeric_limits<Index>::max();
constexpr Index root_arc = no_arc - 1;    ///< the parent of a node that has evidence itself
constexpr Index orphan_arc = no_arc - 2;  ///< the parent was lost

Capacity to_capacity(float weight) {
  if (!(weight >= 0.0F && weight < max_weight)) {
    throw InputError("graph cut", "a weight in [0, 8192)", std::to_string(weight));
  }
  return static_cast<Capacity>(weight * fixed_point + 0.5F);
}

/// Directed arcs by the node that they leave; an arc and its sister have the residual capacities of
/// both directions.
struct Network {
  std::vector<Index> first_arc;  ///< N + 1
  std::vector<Index> head;
  std::vector<Index> sister;
  std::vector<Capacity> residual;
  /// Residual capacity to the terminals: above 0 from the object, below 0 to the background.
  std::vector<std::int64_t> excess;
};

void require_nodes(std::span<const WeightedEdge> edges, std::size_t count) {
  for (const WeightedEdge& edge : edges) {
    if (edge.a >= count || edge.b >= count) {
      throw InputError(
          "graph cut", "edges between " + std::to_string(count) + " nodes",
          "an edge between nodes " + std::to_string(edge.a) + " and " + std::to_string(edge.b));
    }
  }
}

Network build_network(std::span<const Affinity> nodes, std::span<const WeightedEdge> edges) {
  require_nodes(edges, nodes.size());
  Network network;
  network.first_arc.assign(nodes.size() + 1, 0);
  for (const WeightedEdge& edge : edges) {
    ++network.first_arc[edge.a + 1];
    ++network.first_arc[edge.b + 1];
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) network.first_arc[i + 1] += network.first_arc[i];
  network.head.resize(2 * edges.size());
  network.sister.resize(2 * edges.size());
  network.residual.resize(2 * edges.size());
  std::vector<Index> next(network.first_arc.begin(), network.first_arc.end() - 1);
  for (const WeightedEdge& edge : edges) {
    const Capacity capacity = to_capacity(edge.weight);
    const Index forth = next[edge.a]++;
    const Index back = next[edge.b]++;
    network.head[forth] = edge.b;
    network.head[back] = edge.a;
    network.sister[forth] = back;
    network.sister[back] = forth;
    network.residual[forth] = network.residual[back] = capacity;
  }
  network.excess.reserve(nodes.size());
  for (const Affinity& node : nodes) {
    network.excess.push_back(std::int64_t{to_capacity(node.object)} - to_capacity(node.background));
  }
  return network;
}

/// Grows a forest from the nodes with evidence for the object and pushes flow from it into the
/// background.
class MaxFlow {
 public:
  explicit MaxFlow(Network& network)
      : network_(network),
        parent_(network.excess.size(), no_arc),
        depth_(network.excess.size(), 0),
        checked_(network.excess.size(), 0),
        queued_(network.excess.size(), 0) {}

  /// Runs to the end and gives the flow between nodes, in fixed point.
  std::int64_t run() {
    for (Index i = 0; i < network_.excess.size(); ++i) {
      if (network_.excess[i] <= 0) continue;
      parent_[i] = root_arc;
      activate(i);
    }
    for (std::size_t next = 0; next < active_.size(); ++next) {
      const Index node = active_[next];
      queued_[node] = 0;
      if (in_tree(node)) grow(node);
      compact(next);
    }
    return flow_;
  }

  bool in_tree(Index node) const { return parent_[node] != no_arc; }

 private:
  void activate(Index node) {
    if (queued_[node] != 0) return;
    queued_[node] = 1;
    active_.push_back(node);
  }

  /// Drops the part of the queue that is done, now and then.
  void compact(std::size_t& next) {
    if (next < 65536) return;
    active_.erase(active_.begin(), active_.begin() + static_cast<std::ptrdiff_t>(next) + 1);
    next = std::numeric_limits<std::size_t>::max();
  }

  void grow(Index node) {
    for (Index arc = network_.first_arc[node]; arc < network_.first_arc[node + 1]; ++arc) {
      if (network_.residual[arc] == 0) continue;
      const Index to = network_.head[arc];
      if (in_tree(to)) {
        shorten(node, to, arc);
        continue;
      }
      attach(to, network_.sister[arc], node);
      while (in_tree(to) && network_.excess[to] < 0) augment(to);
      if (in_tree(to)) activate(to);
      if (!in_tree(node)) return;
    }
  }

  void attach(Index node, Index to_parent, Index parent) {
    parent_[node] = to_parent;
    depth_[node] = depth_[parent] + 1;
    checked_[node] = checked_[parent];
  }

  /// A shorter way to the root for a node of the tree, where that is known to be up to date.
  void shorten(Index node, Index to, Index arc) {
    if (parent_[to] != root_arc && checked_[to] <= checked_[node] &&
        depth_[to] > depth_[node] + 1) {
      attach(to, network_.sister[arc], node);
    }
  }

  /// Pushes what the path from the root to `last` carries into the background.
  void augment(Index last) {
    std::int64_t amount = -network_.excess[last];
    Index root = last;
    for (; parent_[root] != root_arc; root = network_.head[parent_[root]]) {
      amount = std::min<std::int64_t>(amount, network_.residual[network_.sister[parent_[root]]]);
    }
    amount = std::min(amount, network_.excess[root]);
    push(last, root, amount);
    flow_ += amount;
    ++time_;
    adopt_orphans();
  }

  void push(Index last, Index root, std::int64_t amount) {
    const auto change = static_cast<Capacity>(amount);
    network_.excess[last] += amount;
    for (Index node = last; node != root;) {
      const Index up = parent_[node];
      const Index parent = network_.head[up];
      network_.residual[up] += change;
      network_.residual[network_.sister[up]] -= change;
      if (network_.residual[network_.sister[up]] == 0) make_orphan(node);
      node = parent;
    }
    network_.excess[root] -= amount;
    if (network_.excess[root] == 0) make_orphan(root);
  }

  void make_orphan(Index node) {
    parent_[node] = orphan_arc;
    orphans_.push_back(node);
  }

  void adopt_orphans() {
    for (std::size_t next = 0; next < orphans_.size(); ++next) {
      const Index node = orphans_[next];
      const Index best = nearest_parent(node);
      if (best == no_arc) {
        release(node);
      } else {
        attach(node, best, network_.head[best]);
      }
    }
    orphans_.clear();
  }

  /// The arc to the neighbour nearest to a root that can carry flow to `node`.
  Index nearest_parent(Index node) {
    Index best = no_arc;
    std::uint32_t best_depth = std::numeric_limits<std::uint32_t>::max();
    for (Index arc = network_.first_arc[node]; arc < network_.first_arc[node + 1]; ++arc) {
      if (network_.residual[network_.sister[arc]] == 0) continue;
      const Index neighbour = network_.head[arc];
      if (!in_tree(neighbour)) continue;
      const std::uint32_t depth = depth_if_rooted(neighbour);
      if (depth >= best_depth) continue;
      best = arc;
      best_depth = depth;
    }
    return best;
  }

  /// Steps from `node` to its root, or the greatest number if an orphan is in the way. Marks the
  /// way as checked.
  std::uint32_t depth_if_rooted(Index node) {
    std::uint32_t steps = 0;
    Index at = node;
    while (checked_[at] != time_) {
      const Index up = parent_[at];
      if (up == orphan_arc) return std::numeric_limits<std::uint32_t>::max();
      if (up == root_arc) {
        depth_[at] = 0;
        checked_[at] = time_;
        break;
      }
      ++steps;
      at = network_.head[up];
    }
    const std::uint32_t depth = depth_[at] + steps;
    std::uint32_t here = depth;
    for (at = node; checked_[at] != time_; at = network_.head[parent_[at]]) {
      checked_[at] = time_;
      depth_[at] = here--;
    }
    return depth;
  }

  /// Cuts a node off the tree: its children become orphans, its neighbours may reach it again.
  void release(Index node) {
    parent_[node] = no_arc;
    for (Index arc = network_.first_arc[node]; arc < network_.first_arc[node + 1]; ++arc) {
      const Index neighbour = network_.head[arc];
      if (!in_tree(neighbour)) continue;
      if (network_.residual[network_.sister[arc]] != 0) activate(neighbour);
      const Index up = parent_[neighbour];
      if (up < orphan_arc && network_.head[up] == node) make_orphan(neighbour);
    }
  }

  Network& network_;
  std::vector<Index> parent_;           ///< the arc to the parent
  std::vector<std::uint32_t> depth_;    ///< steps to the root when last checked
  std::vector<std::uint32_t> checked_;  ///< the augmentation at which depth_ was known to hold
  std::vector<std::uint8_t> queued_;
  std::vector<Index> active_;
  std::vector<Index> orphans_;
  std::int64_t flow_ = 0;
  std::uint32_t time_ = 1;
};

}  // namespace

GraphCut cut_graph(std::span<const Affinity> nodes, std::span<const WeightedEdge> edges) {
  Network network = build_network(nodes, edges);
  MaxFlow max_flow(network);
  std::int64_t flow = max_flow.run();
  // What a node's own two terminal edges carry never enters the graph.
  for (const Affinity& node : nodes) flow += to_capacity(std::min(node.object, node.background));

  GraphCut cut;
  cut.is_object.resize(nodes.size());
  for (Index i = 0; i < nodes.size(); ++i) cut.is_object[i] = max_flow.in_tree(i) ? 1 : 0;
  cut.flow = static_cast<double>(flow) / double{fixed_point};
  return cut;
}

double labeling_energy(std::span<const Affinity> nodes, std::span<const WeightedEdge> edges,
                       std::span<const std::uint8_t> is_object) {
  std::int64_t energy = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    energy += to_capacity(is_object[i] != 0 ? nodes[i].background : nodes[i].object);
  }
  for (const WeightedEdge& edge : edges) {
    if (is_object[edge.a] != is_object[edge.b]) energy += to_capacity(edge.weight);
  }
  return static_cast<double>(energy) / double{fixed_point};
}

}  // namespace symscene
