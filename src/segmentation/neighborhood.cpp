#include "neighborhood.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace symscene {
namespace {

constexpr Index not_inside = ~Index{0};

/// Coarse cells: a neighbourhood is larger than an object. Changes no result.
float cell_size_of(const PointCloud& cloud, const NeighborhoodOptions& options) {
  constexpr float cells_along_a_side = 64.0F;
  const float side = bounding_box(cloud.positions).extent().maxCoeff() / cells_along_a_side;
  return std::max(
      {side, 0.25F * static_cast<float>(options.margin), std::numeric_limits<float>::min()});
}

}  // namespace

PointIndices LocalSurface::in_whole(const PointIndices& local) const {
  PointIndices whole(local.size());
  std::transform(local.begin(), local.end(), whole.begin(), [&](Index k) { return points[k]; });
  return whole;
}

PointIndices LocalSurface::in_part(const PointIndices& whole) const {
  PointIndices local(whole.size());
  std::transform(whole.begin(), whole.end(), local.begin(), [&](Index i) {
    const auto place = std::lower_bound(points.begin(), points.end(), i);
    return static_cast<Index>(place - points.begin());
  });
  return local;
}

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

std::optional<LocalSurface> Neighborhoods::around(const PointIndices& support) const {
  if (support.empty()) return std::nullopt;
  LocalSurface local;
  local.points = points_around(support);
  if (local.points.size() == cloud_.size()) return std::nullopt;
  local.cloud = select(cloud_, local.points);
  std::vector<Index> place(cloud_.size(), not_inside);
  for (Index k = 0; k < local.points.size(); ++k) place[local.points[k]] = k;
  for (const Index i : local.points) {
    for (Index e = first_edge_[i]; e < first_edge_[i + 1]; ++e) {
      const WeightedEdge& edge = edges_[e];
      if (place[edge.b] != not_inside)
        local.edges.push_back({place[i], place[edge.b], edge.weight});
    }
  }
  return local;
}

}  // namespace symscene
