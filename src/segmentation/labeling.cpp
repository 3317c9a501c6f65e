#include "labeling.hpp"

#include <algorithm>

#include "core/disjoint_sets.hpp"

namespace symscene {

double smoothness(const std::vector<std::uint8_t>& is_object, std::span<const WeightedEdge> edges) {
  double broken = 0.0;
  for (const WeightedEdge& edge : edges) {
    if (is_object[edge.a] != is_object[edge.b]) broken += double{edge.weight};
  }
  const auto size =
      static_cast<double>(std::count(is_object.begin(), is_object.end(), std::uint8_t{1}));
  return size > 0.0 ? broken / size : 0.0;
}

std::vector<Index> connected_components(const std::vector<std::uint8_t>& is_object,
                                        std::span<const WeightedEdge> edges) {
  DisjointSets sets(is_object.size());
  for (const WeightedEdge& edge : edges) {
    if (is_object[edge.a] != 0 && is_object[edge.b] != 0) sets.join(edge.a, edge.b);
  }
  std::vector<Index> component(is_object.size(), no_component);
  Index next = 0;
  for (Index i = 0; i < is_object.size(); ++i) {
    if (is_object[i] == 0) continue;
    const Index leader = sets.leader(i);
    component[i] = leader == i ? next++ : component[leader];
  }
  return component;
}

void drop_small_components(std::vector<std::uint8_t>& is_object,
                           const std::vector<WeightedEdge>& edges, double min_share) {
  const std::vector<Index> component = connected_components(is_object, edges);
  std::vector<std::size_t> sizes;
  for (const Index c : component) {
    if (c == no_component) continue;
    sizes.resize(std::max<std::size_t>(sizes.size(), c + 1), 0);
    ++sizes[c];
  }
  if (sizes.empty()) return;
  const double least =
      min_share * static_cast<double>(*std::max_element(sizes.begin(), sizes.end()));
  for (Index i = 0; i < is_object.size(); ++i) {
    if (is_object[i] != 0 && static_cast<double>(sizes[component[i]]) < least) is_object[i] = 0;
  }
}

PointIndices object_nodes(const std::vector<std::uint8_t>& is_object) {
  PointIndices nodes;
  for (Index i = 0; i < is_object.size(); ++i) {
    if (is_object[i] != 0) nodes.push_back(i);
  }
  return nodes;
}

}  // namespace symscene
