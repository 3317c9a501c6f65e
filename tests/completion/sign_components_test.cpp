#include "completion/sign_components.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace symscene {
namespace {

constexpr int middle = 10;

NodeGrid odd_grid() {
  NodeGrid grid;
  grid.size = {21, 21, 21};
  return grid;
}

/// Inside where `is_inside(r)`, with r the largest coordinate from the middle.
template <class IsInside>
std::vector<float> field_of_cubes(const NodeGrid& grid, const IsInside& is_inside) {
  std::vector<float> field(grid.nodes());
  for_each_node(grid, [&](std::size_t node, int x, int y, int z) {
    const int r = std::max({std::abs(x - middle), std::abs(y - middle), std::abs(z - middle)});
    field[node] = is_inside(r) ? -1.0F : 1.0F;
  });
  return field;
}

/// Without removal first, the crumb alone would turn to the outside, as a hole in a full body.
TEST(SignComponents, AShellWithACrumbInsideBecomesAFullBody) {
  const NodeGrid grid = odd_grid();
  std::vector<float> field = field_of_cubes(grid, [](int r) { return r == 0 || (r > 4 && r < 7); });
  remove_small_pieces(grid, 0.05, field);
  EXPECT_EQ(field, field_of_cubes(grid, [](int r) { return r > 4 && r < 7; }));
  fill_pockets(grid, field);
  EXPECT_EQ(field, field_of_cubes(grid, [](int r) { return r < 7; }));
}

TEST(SignComponents, PiecesOfTheLeastShareStay) {
  const NodeGrid grid = odd_grid();
  const auto two = field_of_cubes(grid, [](int r) { return r < 2 || (r > 4 && r < 7); });
  std::vector<float> field = two;
  const double share = 27.0 / (13 * 13 * 13 - 9 * 9 * 9);
  remove_small_pieces(grid, 0.99 * share, field);
  EXPECT_EQ(field, two);
  remove_small_pieces(grid, 1.01 * share, field);
  EXPECT_NE(field, two);
}

TEST(SignComponents, AnOpenCavityIsNoPocket) {
  const NodeGrid grid = odd_grid();
  std::vector<float> field = field_of_cubes(grid, [](int r) { return r > 4 && r < 7; });
  for (int z = middle + 5; z < middle + 7; ++z) field[grid.at(middle, middle, z)] = 1.0F;
  const std::vector<float> open = field;
  fill_pockets(grid, field);
  EXPECT_EQ(field, open);
}

}  // namespace
}  // namespace symscene
