#include "segmentation/removal.hpp"

namespace symscene {
namespace {

constexpr Index removed = ~Index{0};

bool is_certain(const Hypothesis& hypothesis, const RemovalOptions& options) {
  return !judge(hypothesis, options.bounds, "rotational") &&
         confidence(hypothesis.residuals, options.bounds) >= options.min_confidence;
}

/// The points of a cloud of `count` that no certain hypothesis holds.
PointIndices uncovered_points(std::size_t count, const std::vector<Hypothesis>& hypotheses,
                              const RemovalOptions& options) {
  std::vector<bool> covered(count, false);
  for (const Hypothesis& hypothesis : hypotheses) {
    if (!is_certain(hypothesis, options)) continue;
    for (const Index i : hypothesis.points) covered[i] = true;
  }
  PointIndices uncovered;
  for (Index i = 0; i < count; ++i) {
    if (!covered[i]) uncovered.push_back(i);
  }
  return uncovered;
}

/// One per point of the whole cloud: its index among the kept points, or `removed`.
std::vector<Index> renumbered(std::size_t count, const PointIndices& kept) {
  std::vector<Index> place(count, removed);
  for (Index k = 0; k < kept.size(); ++k) place[kept[k]] = k;
  return place;
}

PointIndices kept_points(const PointIndices& points, const std::vector<Index>& place) {
  PointIndices kept;
  for (const Index i : points) {
    if (place[i] != removed) kept.push_back(place[i]);
  }
  return kept;
}

}  // namespace

PointIndices Remainder::in_whole(const PointIndices& points) const {
  PointIndices whole;
  whole.reserve(points.size());
  for (const Index i : points) whole.push_back(original[i]);
  return whole;
}

Remainder without_rotational_objects(const Workspace& space,
                                     const std::vector<Hypothesis>& hypotheses,
                                     const RemovalOptions& options) {
  Remainder rest;
  rest.original = uncovered_points(space.cloud.size(), hypotheses, options);
  rest.cloud = select(space.cloud, rest.original);
  const std::vector<Index> place = renumbered(space.cloud.size(), rest.original);
  for (const WeightedEdge& edge : space.edges) {
    if (place[edge.a] != removed && place[edge.b] != removed)
      rest.edges.push_back({place[edge.a], place[edge.b], edge.weight});
  }
  for (const PointIndices& segment : space.segments) {
    PointIndices kept = kept_points(segment, place);
    if (kept.size() >= static_cast<std::size_t>(options.min_segment_size))
      rest.segments.push_back(std::move(kept));
  }
  return rest;
}

}  // namespace symscene
