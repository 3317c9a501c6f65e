#include "slivers.hpp"

#include <algorithm>
#include <cstdint>

namespace symscene {
namespace {

constexpr int half_width = 2;  // of the cube of nodes around a node
// A plane leaves 75 of the 125 nodes inside, a right-angled edge 45, a layer of one node 25, a
// column of two by two nodes 20.
constexpr int fewest_inside = 37;

/// Sums over the nodes up to `half_width` away along an axis.
std::vector<std::uint8_t> summed_along(const NodeGrid& grid, int axis,
                                       const std::vector<std::uint8_t>& counts) {
  std::vector<std::uint8_t> sums(counts.size(), 0);
  const auto stride = static_cast<std::ptrdiff_t>(grid.stride(axis));
  for_each_node(grid, [&](std::size_t node, int x, int y, int z) {
    const int at = axis == 0 ? x : axis == 1 ? y : z;
    int sum = 0;
    for (int step = std::max(-half_width, -at);
         step <= std::min(half_width, grid.size[axis] - 1 - at); ++step)
      sum += counts[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + step * stride)];
    sums[node] = static_cast<std::uint8_t>(sum);
  });
  return sums;
}

/// The numbers of inside nodes in the cubes around the nodes.
std::vector<std::uint8_t> inside_counts(const NodeGrid& grid, const std::vector<float>& field) {
  std::vector<std::uint8_t> counts(field.size());
  std::transform(field.begin(), field.end(), counts.begin(),
                 [](float value) { return static_cast<std::uint8_t>(value < 0.0F ? 1 : 0); });
  for (int axis = 0; axis < 3; ++axis) counts = summed_along(grid, axis, counts);
  return counts;
}

}  // namespace

void remove_slivers(const NodeGrid& grid, const NearestPoints& nearest, float reach,
                    std::vector<float>& field) {
  const std::vector<std::uint8_t> counts = inside_counts(grid, field);
  for (std::size_t node = 0; node < field.size(); ++node) {
    const bool is_hidden = nearest.squared_distance[node] > reach * reach;
    if (field[node] < 0.0F && is_hidden && counts[node] < fewest_inside) field[node] *= -1.0F;
  }
}

}  // namespace symscene
