#pragma once

#include "symscene/baselines/baseline_sweep.hpp"
#include "symscene/segmentation/euclidean_clusters.hpp"

namespace symscene {

/// Euclidean clusters for every distance [m], by default 0.5 to 3 cm in steps of 0.25 cm. The
/// distance in the options is not used.
BaselineSweep euclidean_sweep(const PointCloud& cloud, const EuclideanClusterOptions& options = {},
                              std::vector<double> distances = {});

}  // namespace symscene
