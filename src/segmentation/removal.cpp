#include "segmentation/removal.hpp"

namespace symscene {
namespace {

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

}  // namespace

Remainder without_rotational_objects(const Workspace& space,
                                     const std::vector<Hypothesis>& hypotheses,
                                     const RemovalOptions& options) {
  Remainder rest;
  rest.original = uncovered_points(space.cloud.size(), hypotheses, options);
  rest.cloud = select(space.cloud, rest.original);
  const PartPlaces places(space.cloud.size(), rest.original);
  for (const WeightedEdge& edge : space.edges) places.append(edge, rest.edges);
  for (const PointIndices& segment : space.segments) {
    PointIndices kept = rest.in_part(segment);
    if (kept.size() >= static_cast<std::size_t>(options.min_segment_size))
      rest.segments.push_back(std::move(kept));
  }
  return rest;
}

}  // namespace symscene
