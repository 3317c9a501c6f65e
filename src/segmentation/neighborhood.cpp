#include "neighborhood.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace symscene {
namespace {

/// Coarse cells: a neighbourhood is larger than an object. Changes no result.
float cell_size_of(const PointCloud& cloud, const NeighborhoodOptions& options) {
  constexpr float cells_along_a_side = 64.0F;
  const float side = bounding_box(cloud.positions).extent().maxCoeff() / cells_along_a_side;
  return std::max(
      {side, 0.25F * static_cast<float>(options.margin), std::numeric_limits<float>::min()});
}

}  // namespace

Neighborhoods::Neighborhoods(const ObservedSurface& surface, const NeighborhoodOptions& options)
    : cloud_(surface.cloud),
      edges_(surface.edges),
      first_edge_(surface.cloud.size() + 1, 0),
      cells_(surface.cloud.positions, cell_size_of(surface.cloud, options)),
      options_(options) {
  std::stable_sort(edges_.begin(), edges_.end(),
                   [](const WeightedEdge& a, const WeightedEdge& b) { return a.a < b.a; });
  for (const WeightedEdge& edge : edges_) ++first_edge_[edge.a + 1];
  std::partial_sum(first_edge_.begin(), first_edge_.end(), first_edge_.begin());
}

PointIndices Neighborhoods::points_around(const PointIndices& support) const {
  const Eigen::Vector3f center = centroid(cloud_.positions, support).cast<float>();
  float radius = 0.0F;
  for (const Index i : support) radius = std::max(radius, (cloud_.position(i) - center).norm());
  // Never less than the support itself, whatever is rounded.
  const float reach = 1e-4F * radius + static_cast<float>(options_.reach) * radius +
                      static_cast<float>(options_.margin);
  PointIndices points;
  cells_.for_each_within(center, reach, [&](Index i, float) { points.push_back(i); });
  std::sort(points.begin(), points.end());
  return points;
}

std::optional<SurfacePart> Neighborhoods::around(const PointIndices& support) const {
  if (support.empty()) return std::nullopt;
  SurfacePart part;
  part.original = points_around(support);
  if (part.original.size() == cloud_.size()) return std::nullopt;
  part.cloud = select(cloud_, part.original);
  const PartPlaces places(cloud_.size(), part.original);
  for (const Index i : part.original) {
    for (Index e = first_edge_[i]; e < first_edge_[i + 1]; ++e)
      places.append(edges_[e], part.edges);
  }
  return part;
}

}  // namespace symscene
