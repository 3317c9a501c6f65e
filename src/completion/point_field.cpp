#include "point_field.hpp"

#include <array>
#include <cstdint>
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
      : grid_(grid),
        points_(points),
        exact_(exact),
        nearest_(nearest),
        changed_(static_cast<std::size_t>(grid.size.y()) * static_cast<std::size_t>(grid.size.z()),
                 0) {}

  /// Repeats sweeps up and down until nothing changes: a path of active nodes may turn many times.
  void run() {
    for (int round = 0; round < grid_.size.sum(); ++round) {
      has_changed_ = false;
      sweep(-1);
      sweep(1);
      if (!has_changed_) return;
    }
  }

 private:
  /// Through all rows, each after those on one side of it.
  void sweep(int side) {
    ++sweep_;
    const Eigen::Vector3i& size = grid_.size;
    for (int slice = 0; slice < size.z(); ++slice) {
      const int z = side < 0 ? slice : size.z() - 1 - slice;
      for (int row = 0; row < size.y(); ++row) {
        const int y = side < 0 ? row : size.y() - 1 - row;
        if (may_change(y, z, side)) sweep_row(y, z, side);
      }
    }
  }

  std::size_t row_at(int y, int z) const {
    return static_cast<std::size_t>(z) * static_cast<std::size_t>(grid_.size.y()) +
           static_cast<std::size_t>(y);
  }

  /// Whether the row or one beside it has changed since it was swept from this side.
  bool may_change(int y, int z, int side) const {
    if (sweep_ <= 2) return true;
    const auto is_new = [&](int row_y, int row_z) {
      return row_y >= 0 && row_y < grid_.size.y() && row_z >= 0 && row_z < grid_.size.z() &&
             changed_[row_at(row_y, row_z)] + 1 >= sweep_;
    };
    return is_new(y, z) || is_new(y + side, z) || is_new(y, z + side);
  }

  /// Takes over the candidates of the neighbours on one side, in the order in which they are known.
  void sweep_row(int y, int z, int side) {
    const int length = grid_.size.x();
    const std::size_t first = grid_.at(0, y, z);
    const std::array<bool, 3> within{true, y + side >= 0 && y + side < grid_.size.y(),
                                     z + side >= 0 && z + side < grid_.size.z()};
    for (int column = 0; column < length; ++column) {
      const int x = side < 0 ? column : length - 1 - column;
      const std::size_t node = first + static_cast<std::size_t>(x);
      if (nearest_.squared_distance[node] <= exact_) continue;
      const Eigen::Vector3f position = grid_.position(x, y, z);
      for (int axis = 0; axis < 3; ++axis) {
        const bool has_neighbour =
            axis == 0 ? x + side >= 0 && x + side < length : within[static_cast<std::size_t>(axis)];
        if (!has_neighbour) continue;
        const std::size_t stride = grid_.stride(axis);
        if (improve(node, side < 0 ? node - stride : node + stride, position))
          changed_[row_at(y, z)] = sweep_;
      }
    }
  }

  /// Takes over the point of a neighbour if it is nearer; whether it is.
  bool improve(std::size_t node, std::size_t neighbour, const Eigen::Vector3f& position) {
    const Index candidate = nearest_.point[neighbour];
    if (candidate == NearestPoints::none || candidate == nearest_.point[node]) return false;
    const float squared = (position - points_.positions[candidate]).squaredNorm();
    if (squared >= nearest_.squared_distance[node]) return false;
    nearest_.squared_distance[node] = squared;
    nearest_.point[node] = candidate;
    has_changed_ = true;
    return true;
  }

  const NodeGrid& grid_;
  const SurfacePoints& points_;
  float exact_;
  NearestPoints& nearest_;
  std::vector<std::uint32_t> changed_;  ///< per row, the last sweep that changed a node
  std::uint32_t sweep_ = 0;             ///< counted from 1
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
