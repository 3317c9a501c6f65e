#include "symscene/segmentation/hypothesis.hpp"

#include <algorithm>
#include <cmath>

#include "core/disjoint_sets.hpp"

namespace symscene {
namespace {

/// 1 for a residual of 0, falling to 0 at the bound.
double margin(double residual, double bound) {
  return bound > 0.0 ? std::clamp(1.0 - residual / bound, 0.0, 1.0) : 0.0;
}

}  // namespace

std::optional<Rejection> judge(const Hypothesis& hypothesis, const HypothesisBounds& bounds,
                               const std::string& kind) {
  const std::size_t size = hypothesis.points.size();
  const HypothesisResiduals& residuals = hypothesis.residuals;
  const auto rejection = [&](const char* reason, double value, double bound) {
    return Rejection{kind, reason, value, bound, size, hypothesis.points};
  };
  if (size < static_cast<std::size_t>(bounds.min_size))
    return rejection("size", static_cast<double>(size), static_cast<double>(bounds.min_size));
  if (residuals.symmetry >= bounds.max_symmetry)
    return rejection("symmetry", residuals.symmetry, bounds.max_symmetry);
  if (residuals.occlusion >= bounds.max_occlusion)
    return rejection("occlusion", residuals.occlusion, bounds.max_occlusion);
  if (residuals.smoothness >= bounds.max_smoothness)
    return rejection("smoothness", residuals.smoothness, bounds.max_smoothness);
  return std::nullopt;
}

double confidence(const HypothesisResiduals& residuals, const HypothesisBounds& bounds) {
  return std::cbrt(margin(residuals.symmetry, bounds.max_symmetry) *
                   margin(residuals.occlusion, bounds.max_occlusion) *
                   margin(residuals.smoothness, bounds.max_smoothness));
}

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

PointIndices object_nodes(const std::vector<std::uint8_t>& is_object) {
  PointIndices nodes;
  for (Index i = 0; i < is_object.size(); ++i) {
    if (is_object[i] != 0) nodes.push_back(i);
  }
  return nodes;
}

}  // namespace symscene
