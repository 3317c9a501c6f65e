#include "symscene/segmentation/euclidean_clusters.hpp"

#include "core/disjoint_sets.hpp"
#include "segmentation/segments_of_labels.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {

std::vector<PointIndices> euclidean_clusters(const PointCloud& cloud,
                                             const EuclideanClusterOptions& options) {
  options.validate();
  const auto distance = static_cast<float>(options.distance);
  const CellList cells(cloud.positions, distance);
  DisjointSets sets(cloud.size());
  for (Index i = 0; i < cloud.size(); ++i) {
    cells.for_each_within(cloud.position(i), distance, [&](Index j, float) {
      if (j < i) sets.join(i, j);
    });
  }
  std::vector<Index> labels(cloud.size());
  for (Index i = 0; i < cloud.size(); ++i) labels[i] = sets.leader(i);
  return segments_of_labels(labels, options.min_size);
}

}  // namespace symscene
