#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace symscene {

/// The nodes of a cubic lattice, x running fastest, at which a field is sampled.
struct NodeGrid {
  Eigen::Vector3f origin = Eigen::Vector3f::Zero();  ///< node (0, 0, 0) [m]
  float spacing = 0.0025F;                           ///< [m]
  Eigen::Vector3i size = Eigen::Vector3i::Zero();    ///< nodes along x, y and z

  std::size_t stride(int axis) const {
    const auto row = static_cast<std::size_t>(size.x());
    return axis == 0 ? 1 : axis == 1 ? row : row * static_cast<std::size_t>(size.y());
  }
  std::size_t nodes() const { return stride(2) * static_cast<std::size_t>(size.z()); }
  std::size_t at(int x, int y, int z) const {
    return static_cast<std::size_t>(z) * stride(2) + static_cast<std::size_t>(y) * stride(1) +
           static_cast<std::size_t>(x);
  }
  Eigen::Vector3f position(int x, int y, int z) const {
    return origin + spacing * Eigen::Vector3i(x, y, z).cast<float>();
  }
  bool is_border(int x, int y, int z) const {
    return x == 0 || y == 0 || z == 0 || x == size.x() - 1 || y == size.y() - 1 ||
           z == size.z() - 1;
  }
};

/// Calls visit(node, x, y, z) for every node in order.
template <class Visit>
void for_each_node(const NodeGrid& grid, Visit&& visit) {
  std::size_t node = 0;
  for (int z = 0; z < grid.size.z(); ++z) {
    for (int y = 0; y < grid.size.y(); ++y) {
      for (int x = 0; x < grid.size.x(); ++x) visit(node++, x, y, z);
    }
  }
}

/// Calls visit(node) for the up to six neighbours of a node along the axes.
template <class Visit>
void for_each_neighbour(const NodeGrid& grid, std::size_t node, Visit&& visit) {
  std::size_t rest = node;
  for (int axis = 2; axis >= 0; --axis) {
    const std::size_t stride = grid.stride(axis);
    const std::size_t at = rest / stride;
    rest %= stride;
    if (at > 0) visit(node - stride);
    if (at + 1 < static_cast<std::size_t>(grid.size[axis])) visit(node + stride);
  }
}

/// Goes from the nodes in `open` to neighbours. enter(node, next) marks `next` and returns true if
/// it is to be gone to from `node` and was not before.
template <class Enter>
void flood(const NodeGrid& grid, std::vector<std::size_t> open, Enter&& enter) {
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    for_each_neighbour(grid, node, [&](std::size_t next) {
      if (enter(node, next)) open.push_back(next);
    });
  }
}

/// Calls visit(node, offset from the point, squared distance) for the nodes within `radius` of a
/// point.
template <class Visit>
void for_each_node_within(const NodeGrid& grid, const Eigen::Vector3f& point, float radius,
                          Visit&& visit) {
  const Eigen::Array3f at = (point - grid.origin).array() / grid.spacing;
  const float reach = radius / grid.spacing;
  const Eigen::Array3i low = (at - reach).ceil().cast<int>().max(0);
  const Eigen::Array3i high = (at + reach).floor().cast<int>().min(grid.size.array() - 1);
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      Eigen::Vector3f offset = grid.position(low.x(), y, z) - point;
      std::size_t node = grid.at(low.x(), y, z);
      for (int x = low.x(); x <= high.x(); ++x, ++node, offset.x() += grid.spacing) {
        const float squared = offset.squaredNorm();
        if (squared <= radius * radius) visit(node, offset, squared);
      }
    }
  }
}

}  // namespace symscene
