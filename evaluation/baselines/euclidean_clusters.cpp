#include "symscene/baselines/euclidean_clusters.hpp"

#include "core/disjoint_sets.hpp"
#include "core/evenly_spaced.hpp"
#include "core/parallel.hpp"
#include "segments.hpp"
#include "symscene/core/error.hpp"
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

BaselineSweep euclidean_sweep(const PointCloud& cloud, const EuclideanClusterOptions& options,
                              std::vector<double> distances) {
  if (distances.empty()) distances = evenly_spaced(0.005, 0.03, 0.0025);
  BaselineSweep sweep{"Euclidean clusters", "distance", std::move(distances), {}};
  sweep.masks.resize(sweep.values.size());
  parallel_for_each(sweep.values.size(), [&](std::size_t i) {
    EuclideanClusterOptions at = options;
    at.distance = sweep.values[i];
    sweep.masks[i] = euclidean_clusters(cloud, at);
  });
  return sweep;
}

}  // namespace symscene
