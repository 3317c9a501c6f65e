#include "completion/slivers.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

constexpr float reach = 0.01F;

NodeGrid even_grid() {
  NodeGrid grid;
  grid.size = {20, 20, 20};
  return grid;
}

/// Inside where `is_inside(x, y, z)`, with all points far away.
template <class IsInside>
std::vector<float> without_slivers(const NodeGrid& grid, float squared_distance,
                                   const IsInside& is_inside) {
  std::vector<float> field(grid.nodes());
  for_each_node(grid, [&](std::size_t node, int x, int y, int z) {
    field[node] = is_inside(x, y, z) ? -1.0F : 1.0F;
  });
  NearestPoints nearest;
  nearest.point.assign(grid.nodes(), 0);
  nearest.squared_distance.assign(grid.nodes(), squared_distance);
  remove_slivers(grid, nearest, reach, field);
  return field;
}

TEST(Slivers, OfOneNodeAreRemovedFarFromPointsOnly) {
  const NodeGrid grid = even_grid();
  const auto layer = [](int, int, int z) { return z == 10; };
  const auto column = [](int x, int y, int) { return x / 2 == 5 && y / 2 == 5; };
  EXPECT_EQ(without_slivers(grid, 1.0F, layer)[grid.at(10, 10, 10)], 1.0F);
  EXPECT_EQ(without_slivers(grid, 1.0F, column)[grid.at(10, 10, 10)], 1.0F);
  EXPECT_EQ(without_slivers(grid, 1e-6F, layer)[grid.at(10, 10, 10)], -1.0F);
}

TEST(Slivers, EdgesOfABodyStay) {
  const NodeGrid grid = even_grid();
  const std::vector<float> field = without_slivers(
      grid, 1.0F, [](int x, int y, int) { return x >= 5 && x < 15 && y >= 5 && y < 15; });
  for (int z = 2; z < 18; ++z) {
    EXPECT_EQ(field[grid.at(5, 5, z)], -1.0F);
    EXPECT_EQ(field[grid.at(14, 10, z)], -1.0F);
    EXPECT_EQ(field[grid.at(4, 5, z)], 1.0F);
  }
}

}  // namespace
}  // namespace symscene
