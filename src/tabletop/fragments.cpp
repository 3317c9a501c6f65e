#include "fragments.hpp"

#include <algorithm>

#include "core/spacing.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {

std::vector<Index> fragments_of(const Points& points, double link) {
  const auto size = static_cast<Index>(points.rows());
  std::vector<Index> fragment(size, size);
  if (size == 0) return fragment;
  const NeighborLists neighbors = radius_neighbors(points, static_cast<float>(link));
  std::vector<Index> open;
  Index count = 0;
  for (Index seed = 0; seed < size; ++seed) {
    if (fragment[seed] != size) continue;
    fragment[seed] = count;
    open.push_back(seed);
    while (!open.empty()) {
      const Index i = open.back();
      open.pop_back();
      for (const Index other : neighbors.of(i)) {
        if (fragment[other] != size) continue;
        fragment[other] = count;
        open.push_back(other);
      }
    }
    ++count;
  }
  return fragment;
}

FragmentBounds bounds_for(const Points& points, const TableCropOptions& options) {
  constexpr double diagonal = 1.5;
  constexpr std::size_t least = 8;
  const std::optional<float> spacing = median_spacing(points);
  if (!spacing) return {options.link, static_cast<std::size_t>(options.min_fragment)};
  const double ratio = std::max(diagonal * *spacing / options.voxel_size, 1.0);
  const auto count = static_cast<std::size_t>(options.min_fragment / (ratio * ratio));
  return {ratio * options.link,
          std::max(count, std::min(least, static_cast<std::size_t>(options.min_fragment)))};
}

PointIndices points_in_fragments(const Points& points, const TableCropOptions& options) {
  const FragmentBounds bounds = bounds_for(points, options);
  const std::vector<Index> fragment = fragments_of(points, bounds.link);
  std::vector<std::size_t> sizes(fragment.size(), 0);
  for (const Index f : fragment) ++sizes[f];
  PointIndices kept;
  for (Index i = 0; i < fragment.size(); ++i) {
    if (sizes[fragment[i]] >= bounds.least) kept.push_back(i);
  }
  return kept;
}

}  // namespace symscene
