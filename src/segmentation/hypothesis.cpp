#include "symscene/segmentation/hypothesis.hpp"

#include <algorithm>
#include <cmath>

#include "core/disjoint_sets.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

double margin(double value, double bound) {
  return bound > 0.0 ? std::clamp(1.0 - value / bound, 0.0, 1.0) : 0.0;
}

}  // namespace

void HypothesisBounds::validate() const {
  for (const double bound : {max_symmetry, max_occlusion, max_smoothness}) {
    require_option(bound >= 0.0 && std::isfinite(bound),
                   "max_symmetry, max_occlusion, max_smoothness", "scores of at least 0", bound);
  }
  require_option(min_size >= 1, "min_size", "at least 1 point", min_size);
}

std::optional<Rejection> judge(const Hypothesis& hypothesis, const HypothesisBounds& bounds,
                               const std::string& kind) {
  const std::size_t size = hypothesis.points.size();
  const HypothesisScores& scores = hypothesis.scores;
  const auto refusal = [&](const char* reason, double value, double bound) {
    return Rejection{kind, reason, value, bound, size, hypothesis.points};
  };
  if (size < static_cast<std::size_t>(bounds.min_size))
    return refusal("size", static_cast<double>(size), static_cast<double>(bounds.min_size));
  if (scores.symmetry >= bounds.max_symmetry)
    return refusal("symmetry", scores.symmetry, bounds.max_symmetry);
  if (scores.occlusion >= bounds.max_occlusion)
    return refusal("occlusion", scores.occlusion, bounds.max_occlusion);
  if (scores.smoothness >= bounds.max_smoothness)
    return refusal("smoothness", scores.smoothness, bounds.max_smoothness);
  return std::nullopt;
}

double confidence(const HypothesisScores& scores, const HypothesisBounds& bounds) {
  return std::cbrt(margin(scores.symmetry, bounds.max_symmetry) *
                   margin(scores.occlusion, bounds.max_occlusion) *
                   margin(scores.smoothness, bounds.max_smoothness));
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
