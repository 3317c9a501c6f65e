#include "object_feature_extractor.hpp"

#include <algorithm>
#include <cmath>

#include "symmetry_fit.hpp"

namespace symscene {
namespace {

constexpr double min_length = 1e-6;  // [m], of a proposal of one point

}  // namespace

ObjectFeatureExtractor::ObjectFeatureExtractor(const SegmentedScene& scene,
                                               const ProposalOptions& options)
    : scene_(scene),
      options_(options),
      cells_(scene.cloud.positions, static_cast<float>(options.object_features.neighbor_distance)) {
  const PointCloud& cloud = scene.cloud;
  first_.assign(std::size_t{cloud.size()} + 1, 0);
  for (const WeightedEdge& edge : scene.edges) {
    ++first_[edge.a + 1];
    ++first_[edge.b + 1];
  }
  for (Index i = 0; i < cloud.size(); ++i) first_[i + 1] += first_[i];
  neighbors_.resize(2 * scene.edges.size());
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (const WeightedEdge& edge : scene.edges) {
    const bool concave = !bends_outwards(cloud, edge.a, edge.b);
    neighbors_[next[edge.a]++] = {edge.b, edge.weight, concave};
    neighbors_[next[edge.b]++] = {edge.a, edge.weight, concave};
  }
}

OwnFeatures ObjectFeatureExtractor::features(const MergedHypothesis& merged) const {
  const PointIndices& points = merged.points;
  Flags inside(scene_.cloud.size(), 0);
  for (const Index i : points) inside[i] = 1;
  const EdgeFeatures edges = edge_features(points, inside);
  const PairFeatures pairs = pair_features(points);
  const ExtentFeatures extent = extent_features(points);
  const SymmetryFit symmetry = symmetry_fit(merged, scene_.cloud, scene_.field, options_);
  return {.broken = edges.broken,
          .torn = edges.torn,
          .rim = edges.rim,
          .bend = edges.bend,
          .crease = edges.crease,
          .seam = scene_.regions.seam(points),
          .fold = scene_.patches.seam(points),
          .fold_rim = scene_.patches.rim(points),
          .unity = largest_component(points, inside),
          .near_unity = scene_.patches.unity(points),
          .convexity = pairs.convexity,
          .empty = pairs.empty,
          .width_ratio = extent.width_ratio,
          .thickness_ratio = extent.thickness_ratio,
          .near_others = share_near_others(points, inside),
          .axes = symmetry.axes,
          .axis_misfit = symmetry.axis_misfit,
          .axis_occlusion = symmetry.axis_occlusion,
          .planes = symmetry.planes,
          .plane_inlier = symmetry.plane_inlier,
          .plane_occlusion = symmetry.plane_occlusion,
          .confidence = merged.confidence};
}

bool ObjectFeatureExtractor::is_crease(const Neighbor& neighbor) const {
  return neighbor.concave &&
         neighbor.weight < static_cast<float>(options_.object_features.crease_weight);
}

ObjectFeatureExtractor::EdgeFeatures ObjectFeatureExtractor::edge_features(
    const PointIndices& points, const Flags& inside) const {
  double rim = 0, leaving = 0, leaving_weight = 0, torn = 0;
  double edges = 0, weakness = 0, creases = 0;
  for (const Index i : points) {
    bool on_rim = false;
    for (Index k = first_[i]; k < first_[i + 1]; ++k) {
      const Neighbor& neighbor = neighbors_[k];
      if (inside[neighbor.index] != 0) {
        edges += 1.0;
        weakness += neighbor.concave ? 1.0 - double{neighbor.weight} : 0.0;
        creases += is_crease(neighbor) ? 1.0 : 0.0;
      } else {
        on_rim = true;
        leaving += 1.0;
        leaving_weight += double{neighbor.weight};
        torn += is_crease(neighbor) ? 0.0 : 1.0;
      }
    }
    rim += on_rim ? 1.0 : 0.0;
  }
  const double root = std::sqrt(static_cast<double>(points.size()));
  return {.broken = leaving_weight / root,
          .torn = leaving > 0.0 ? torn / leaving : 0.0,
          .rim = rim / root,
          .bend = edges > 0.0 ? weakness / edges : 0.0,
          .crease = edges > 0.0 ? creases / edges : 0.0};
}

ObjectFeatureExtractor::PairFeatures ObjectFeatureExtractor::pair_features(
    const PointIndices& points) const {
  const ObjectFeatureOptions& options = options_.object_features;
  const auto max_offset = static_cast<float>(options.convex_offset);
  const auto max_slope = static_cast<float>(options.convex_slope);
  const auto empty_distance = static_cast<float>(options.empty_distance);
  PointIndices sample;
  for (const Index k :
       evenly_spread(static_cast<Index>(points.size()), static_cast<Index>(options.pair_points)))
    sample.push_back(points[k]);
  double pairs = 0, convex = 0, places = 0, empty = 0;
  for (std::size_t a = 0; a < sample.size(); ++a) {
    const Eigen::Vector3f p = scene_.cloud.position(sample[a]), n = scene_.cloud.normal(sample[a]);
    for (std::size_t b = 0; b < a; ++b) {
      const Eigen::Vector3f q = scene_.cloud.position(sample[b]);
      const Eigen::Vector3f m = scene_.cloud.normal(sample[b]);
      pairs += 1.0;
      const float protrusion = max_offset + max_slope * (q - p).norm();
      convex += n.dot(q - p) < protrusion && m.dot(p - q) < protrusion ? 1.0 : 0.0;
      for (const float t : {0.25F, 0.5F, 0.75F}) {
        places += 1.0;
        empty += scene_.field.at(p + t * (q - p)) > empty_distance ? 1.0 : 0.0;
      }
    }
  }
  return {.convexity = pairs > 0.0 ? convex / pairs : 1.0,
          .empty = places > 0.0 ? empty / places : 0.0};
}

ObjectFeatureExtractor::ExtentFeatures ObjectFeatureExtractor::extent_features(
    const PointIndices& points) const {
  Points positions(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t k = 0; k < points.size(); ++k)
    positions.row(static_cast<Eigen::Index>(k)) = scene_.cloud.positions.row(points[k]);
  const Eigen::Matrix3f axes = principal_axes(positions).cast<float>();
  const Points along = positions * axes;
  const Eigen::RowVector3f extent = along.colwise().maxCoeff() - along.colwise().minCoeff();
  const double length = std::max(double{extent[0]}, min_length);
  return {double{extent[1]} / length, double{extent[2]} / length};
}

/// The share of the largest connected component of the surface graph inside the proposal.
double ObjectFeatureExtractor::largest_component(const PointIndices& points, Flags inside) const {
  std::size_t largest = 0;
  PointIndices reached;
  for (const Index seed : points) {
    if (inside[seed] == 0) continue;
    reached.assign(1, seed);
    inside[seed] = 0;
    for (std::size_t next = 0; next < reached.size(); ++next) {
      const Index i = reached[next];
      for (Index k = first_[i]; k < first_[i + 1]; ++k) {
        const Index j = neighbors_[k].index;
        if (inside[j] == 0) continue;
        inside[j] = 0;
        reached.push_back(j);
      }
    }
    largest = std::max(largest, reached.size());
  }
  return static_cast<double>(largest) / static_cast<double>(points.size());
}

double ObjectFeatureExtractor::share_near_others(const PointIndices& points,
                                                 const Flags& inside) const {
  const ObjectFeatureOptions& options = options_.object_features;
  const auto near = static_cast<float>(options.neighbor_distance);
  std::size_t close = 0;
  const PointIndices sample =
      evenly_spread(static_cast<Index>(points.size()), static_cast<Index>(options.neighbor_points));
  for (const Index k : sample) {
    bool other = false;
    cells_.for_each_within(scene_.cloud.position(points[k]), near,
                           [&](Index j, float) { other = other || inside[j] == 0; });
    close += other ? 1 : 0;
  }
  return static_cast<double>(close) / static_cast<double>(sample.size());
}

}  // namespace symscene
