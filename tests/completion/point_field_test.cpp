#include "completion/point_field.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

constexpr float margin = 1.0F;

NodeGrid flat_grid(int edge) {
  NodeGrid grid;
  grid.spacing = 1.0F;
  grid.size = {edge, edge, 1};
  return grid;
}

/// Distances outside of a bound that makes nodes active where `is_active(x, y)`.
template <class IsActive>
std::vector<float> bound_where(const NodeGrid& grid, const IsActive& is_active) {
  std::vector<float> in_bound(grid.nodes(), margin);
  for_each_node(grid, [&](std::size_t node, int x, int y, int) {
    if (is_active(x, y)) in_bound[node] = 0.0F;
  });
  return in_bound;
}

SurfacePoints points_at(std::vector<Eigen::Vector3f> positions) {
  SurfacePoints points;
  points.observed = positions.size();
  points.normals.assign(positions.size(), Eigen::Vector3f::UnitZ());
  points.positions = std::move(positions);
  return points;
}

/// Steps along x lead up and steps along y lead down, so that no path goes first up and then down.
TEST(NearestPoints, ReachEveryNodeOfADiagonalBand) {
  constexpr int edge = 30;
  const NodeGrid grid = flat_grid(edge);
  const auto in_bound = bound_where(grid, [](int x, int y) {
    const int sum = x + y;
    return sum == edge - 1 || sum == edge;
  });
  const NearestPoints nearest =
      nearest_points(grid, points_at({{0.0F, float{edge - 1}, 0.0F}}), 0.5F, in_bound, margin);
  for (std::size_t node = 0; node < grid.nodes(); ++node) {
    const bool is_active = in_bound[node] < margin;
    EXPECT_EQ(nearest.point[node], is_active ? 0U : NearestPoints::none) << node;
  }
}

TEST(NearestPoints, AreNoneWhereNoActiveNodesLead) {
  const NodeGrid grid = flat_grid(9);
  const auto in_bound = bound_where(grid, [](int x, int) { return x != 4; });
  const NearestPoints nearest =
      nearest_points(grid, points_at({{1.0F, 1.0F, 0.0F}}), 0.5F, in_bound, margin);
  EXPECT_EQ(nearest.point[grid.at(3, 8, 0)], 0U);
  EXPECT_EQ(nearest.point[grid.at(5, 1, 0)], NearestPoints::none);
}

/// All nodes are active, so that candidates reach a node from every side.
TEST(NearestPoints, AreTheNearestOfAll) {
  const NodeGrid grid = flat_grid(20);
  const SurfacePoints points =
      points_at({{2.0F, 3.0F, 0.0F}, {15.0F, 4.0F, 0.0F}, {9.0F, 17.0F, 0.0F}});
  const NearestPoints nearest =
      nearest_points(grid, points, 2.0F, bound_where(grid, [](int, int) { return true; }), margin);
  for_each_node(grid, [&](std::size_t node, int x, int y, int z) {
    float least = 1e9F;
    for (const Eigen::Vector3f& point : points.positions)
      least = std::min(least, (grid.position(x, y, z) - point).squaredNorm());
    EXPECT_EQ(nearest.squared_distance[node], least);
  });
}

}  // namespace
}  // namespace symscene
