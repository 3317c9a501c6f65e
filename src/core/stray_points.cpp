#include "core/stray_points.hpp"

#include "core/parallel.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {

PointIndices points_with_neighbors(const Points& points, double radius, int min_neighbors) {
  const auto reach = static_cast<float>(radius);
  const CellList cells(points, reach);
  const auto count = static_cast<std::size_t>(points.rows());
  std::vector<std::uint8_t> is_kept(count, 0);
  parallel_for_blocks(count, 1024, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      int others = -1;  // the point finds itself
      cells.for_each_within(points.row(i).transpose(), reach, [&](Index, float) { ++others; });
      is_kept[i] = others >= min_neighbors ? 1 : 0;
    }
  });
  PointIndices kept;
  for (Index i = 0; i < count; ++i) {
    if (is_kept[i] != 0) kept.push_back(i);
  }
  return kept;
}

}  // namespace symscene
