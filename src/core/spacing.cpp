#include "core/spacing.hpp"

#include "core/median.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {

std::vector<float> nearest_distances(const Points& points) {
  const NeighborLists nearest = nearest_neighbors(points, 1);
  std::vector<float> distances;
  for (Index i = 0; i < nearest.size(); ++i) {
    for (const Index j : nearest.of(i)) distances.push_back((points.row(i) - points.row(j)).norm());
  }
  return distances;
}

std::optional<float> median_spacing(const Points& points) {
  return median(nearest_distances(points));
}

}  // namespace symscene
