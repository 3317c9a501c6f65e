#include "symscene/baselines/euclidean_sweep.hpp"

#include "core/evenly_spaced.hpp"
#include "core/parallel.hpp"

namespace symscene {

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
