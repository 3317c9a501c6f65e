#include "point_field.hpp"

#include <limits>

namespace symscene {
namespace {

constexpr float observed_weight = 1.0F;
constexpr float image_weight = 0.25F;  // where both are near, the surface is the observed one
constexpr float inactive = -1.0F;      // squared distance of a node that takes no point
constexpr float min_agreement = 0.5F;  // cosine between normals of one face

/// Sums over the points near a node.
struct NodeSums {
  float weight = 0.0F;
  float distance = 0.0F;                             ///< Σ w nᵢ·(x − pᵢ)
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< Σ w nᵢ
  Eigen::Vector3f offset = Eigen::Vector3f::Zero();  ///< Σ w (x − pᵢ)

  /// The mean of Σ w nᵢ·(x − pᵢ) / Σ w, which lies outside of a curved surface, and of
  /// n̄·(x − p̄), which lies as far inside of it: exact for quadrics up to the third order.
  float value() const {
    const float length = normal.norm();
    const float tangent = distance / weight;
    return length > 0.0F ? 0.5F * (tangent + normal.dot(offset) / (length * weight)) : tangent;
  }
};

class Propagation {
 public:
  /// Nodes within `exact` [m²] of their point, and inactive ones, stay as they are.
  Propagation(const NodeGrid& grid, const SurfacePoints& points, float exact,
              NearestPoints& nearest)
      : grid_(grid), points_(points), exact_(exact), nearest_(nearest) {}

  /// Repeats sweeps until nothing changes: a path of active nodes may turn many times.
  void run() {
    for (int round = 0; round < grid_.size.sum(); ++round) {
      if (!sweep()) return;
    }
  }

 private:
  /// Up, then down; whether a node changed.
  bool sweep() {
    has_changed_ = false;
    for (int z = 0; z < grid_.size.z(); ++z) sweep_slice(z, -1);
    for (int z = grid_.size.z() - 1; z >= 0; --z) sweep_slice(z, 1);
    return has_changed_;
  }

  /// Takes over the candidates of the neighbours on one side, in the order in which they are known.
  void sweep_slice(int z, int side) {
    const Eigen::Vector3i& size = grid_.size;
    for (int row = 0; row < size.y(); ++row) {
      const int y = side < 0 ? row : size.y() - 1 - row;
      for (int column = 0; column < size.x(); ++column) {
        const int x = side < 0 ? column : size.x() - 1 - column;
        improve({x, y, z}, side);
      }
    }
  }

  void improve(const Eigen::Vector3i& at, int side) {
    const std::size_t node = grid_.at(at.x(), at.y(), at.z());
    if (nearest_.squared_distance[node] <= exact_) return;
    const Eigen::Vector3f position = grid_.position(at.x(), at.y(), at.z());
    for (int axis = 0; axis < 3; ++axis) {
      const int next = at[axis] + side;
      if (next < 0 || next >= grid_.size[axis]) continue;
      const std::size_t neighbour =
          side < 0 ? node - grid_.stride(axis) : node + grid_.stride(axis);
      const Index candidate = nearest_.point[neighbour];
      if (candidate == NearestPoints::none || candidate == nearest_.point[node]) continue;
      const float squared = (position - points_.positions[candidate]).squaredNorm();
      if (squared >= nearest_.squared_distance[node]) continue;
      nearest_.squared_distance[node] = squared;
      nearest_.point[node] = candidate;
      has_changed_ = true;
    }
  }

  const NodeGrid& grid_;
  const SurfacePoints& points_;
  float exact_;
  NearestPoints& nearest_;
  bool has_changed_ = false;
};

std::vector<NodeSums> sums_near(const NodeGrid& grid, const SurfacePoints& points,
                                const NearestPoints& nearest, float reach) {
  std::vector<NodeSums> sums(grid.nodes());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f& normal = points.normals[i];
    const float own_weight = points.is_observed(i) ? observed_weight : image_weight;
    for_each_node_within(
        grid, points.positions[i], reach,
        [&](std::size_t node, const Eigen::Vector3f& offset, float squared) {
          const Index first = nearest.point[node];
          if (first == NearestPoints::none || normal.dot(points.normals[first]) < min_agreement)
            return;
          const float fall_off = 1.0F - squared / (reach * reach);
          const float weight = own_weight * fall_off * fall_off;
          NodeSums& sum = sums[node];
          sum.weight += weight;
          sum.distance += weight * normal.dot(offset);
          sum.normal += weight * normal;
          sum.offset += weight * offset;
        });
  }
  return sums;
}

}  // namespace

NearestPoints nearest_points(const NodeGrid& grid, const SurfacePoints& points, float reach,
                             const std::vector<float>& in_bound, float margin) {
  NearestPoints nearest;
  nearest.point.assign(grid.nodes(), NearestPoints::none);
  nearest.squared_distance.resize(grid.nodes());
  for (std::size_t node = 0; node < grid.nodes(); ++node)
    nearest.squared_distance[node] =
        in_bound[node] < margin ? std::numeric_limits<float>::max() : inactive;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for_each_node_within(grid, points.positions[i], reach,
                         [&](std::size_t node, const Eigen::Vector3f&, float squared) {
                           if (squared >= nearest.squared_distance[node]) return;
                           nearest.squared_distance[node] = squared;
                           nearest.point[node] = static_cast<Index>(i);
                         });
  }
  Propagation(grid, points, reach * reach, nearest).run();
  return nearest;
}

std::vector<float> signed_distances(const NodeGrid& grid, const SurfacePoints& points,
                                    const NearestPoints& nearest, float reach, float margin) {
  const std::vector<NodeSums> sums = sums_near(grid, points, nearest, reach);
  std::vector<float> distances(grid.nodes(), margin);
  for_each_node(grid, [&](std::size_t node, int x, int y, int z) {
    const Index i = nearest.point[node];
    if (i == NearestPoints::none) return;
    distances[node] = sums[node].weight > 0.0F
                          ? sums[node].value()
                          : points.normals[i].dot(grid.position(x, y, z) - points.positions[i]);
  });
  return distances;
}

}  // namespace symscene
