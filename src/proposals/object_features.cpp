#include "symscene/proposals/object_features.hpp"

#include <algorithm>
#include <cmath>

namespace symscene {
namespace {

constexpr float crease_weight = 0.5F;  ///< an edge below bends inwards clearly
constexpr float near = 0.02F;          // [m]
constexpr Index pair_points = 40;

}  // namespace

ObjectMeter::ObjectMeter(const PointCloud& cloud, const std::vector<WeightedEdge>& edges,
                         const DistanceField& field, const std::optional<Plane>& table)
    : cloud_(cloud), field_(field), table_(table), cells_(cloud.positions, near) {
  first_.assign(std::size_t{cloud.size()} + 1, 0);
  for (const WeightedEdge& edge : edges) {
    ++first_[edge.a + 1];
    ++first_[edge.b + 1];
  }
  for (Index i = 0; i < cloud.size(); ++i) first_[i + 1] += first_[i];
  neighbors_.resize(2 * edges.size());
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (const WeightedEdge& edge : edges) {
    const bool concave = !bends_outwards(cloud, edge.a, edge.b);
    neighbors_[next[edge.a]++] = {edge.b, edge.weight, concave};
    neighbors_[next[edge.b]++] = {edge.a, edge.weight, concave};
  }
}

void ObjectMeter::measure_edges(const PointIndices& points, const std::vector<std::uint8_t>& inside,
                                ObjectFeatures& features) const {
  double rim = 0, leaving = 0, leaving_weight = 0, torn = 0;
  double edges = 0, weakness = 0, creases = 0;
  for (const Index i : points) {
    bool on_rim = false;
    for (Index k = first_[i]; k < first_[i + 1]; ++k) {
      const Neighbor& neighbor = neighbors_[k];
      if (inside[neighbor.index] != 0) {
        edges += 1.0;
        weakness += neighbor.concave ? 1.0 - double{neighbor.weight} : 0.0;
        creases += neighbor.concave && neighbor.weight < crease_weight ? 1.0 : 0.0;
      } else {
        on_rim = true;
        leaving += 1.0;
        leaving_weight += double{neighbor.weight};
        torn += neighbor.concave && neighbor.weight < crease_weight ? 0.0 : 1.0;
      }
    }
    rim += on_rim ? 1.0 : 0.0;
  }
  const auto size = static_cast<double>(points.size());
  const double root = std::sqrt(size);
  features.size = std::log(size);
  features.broken = leaving_weight / root;
  features.torn = leaving > 0.0 ? torn / leaving : 0.0;
  features.rim = rim / root;
  features.bend = edges > 0.0 ? weakness / edges : 0.0;
  features.crease = edges > 0.0 ? creases / edges : 0.0;
}

void ObjectMeter::measure_pairs(const PointIndices& points, ObjectFeatures& features) const {
  PointIndices sample;
  for (const Index k : evenly_spread(static_cast<Index>(points.size()), pair_points))
    sample.push_back(points[k]);
  constexpr float before = 0.005F;  // [m]
  constexpr float free = 0.01F;     // [m]
  double pairs = 0, convex = 0, places = 0, empty = 0;
  for (std::size_t a = 0; a < sample.size(); ++a) {
    const Eigen::Vector3f p = cloud_.position(sample[a]), n = cloud_.normal(sample[a]);
    for (std::size_t b = 0; b < a; ++b) {
      const Eigen::Vector3f q = cloud_.position(sample[b]), m = cloud_.normal(sample[b]);
      pairs += 1.0;
      convex += n.dot(q - p) < before && m.dot(p - q) < before ? 1.0 : 0.0;
      for (const float t : {0.25F, 0.5F, 0.75F}) {
        places += 1.0;
        empty += field_.at(p + t * (q - p)) > free ? 1.0 : 0.0;
      }
    }
  }
  features.convexity = pairs > 0.0 ? convex / pairs : 1.0;
  features.empty = places > 0.0 ? empty / places : 0.0;
}

void ObjectMeter::measure_extent(const PointIndices& points, ObjectFeatures& features) const {
  Points positions(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t k = 0; k < points.size(); ++k)
    positions.row(static_cast<Eigen::Index>(k)) = cloud_.positions.row(points[k]);
  const Eigen::Matrix3f axes = principal_axes(positions).cast<float>();
  const Points along = positions * axes;
  const Eigen::RowVector3f extent = along.colwise().maxCoeff() - along.colwise().minCoeff();
  features.length = double{extent[0]};
  features.width = double{extent[1]};
  features.thickness = double{extent[2]};
  if (!table_) return;
  const Eigen::VectorXf heights =
      (positions * table_->normal.cast<float>()).array() + static_cast<float>(table_->offset);
  features.foot = std::clamp(double{heights.minCoeff()}, 0.0, 0.1);
  features.top = std::clamp(double{heights.maxCoeff()}, 0.0, 0.3);
}

/// The share of the largest piece that edges between points of the set connect.
double ObjectMeter::largest_piece(const PointIndices& points,
                                  std::vector<std::uint8_t> inside) const {
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

double ObjectMeter::share_near_others(const PointIndices& points,
                                      const std::vector<std::uint8_t>& inside) const {
  constexpr Index most_points = 200;
  std::size_t close = 0;
  const PointIndices sample = evenly_spread(static_cast<Index>(points.size()), most_points);
  for (const Index k : sample) {
    bool other = false;
    cells_.for_each_within(cloud_.position(points[k]), near,
                           [&](Index j, float) { other = other || inside[j] == 0; });
    close += other ? 1 : 0;
  }
  return static_cast<double>(close) / static_cast<double>(sample.size());
}

ObjectFeatures ObjectMeter::measure(const PointIndices& points) const {
  std::vector<std::uint8_t> inside(cloud_.size(), 0);
  for (const Index i : points) inside[i] = 1;
  ObjectFeatures features;
  measure_edges(points, inside, features);
  measure_pairs(points, features);
  measure_extent(points, features);
  features.unity = largest_piece(points, inside);
  features.near_others = share_near_others(points, inside);
  return features;
}

}  // namespace symscene
