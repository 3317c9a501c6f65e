#pragma once

#include "symscene/baselines/baseline_sweep.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

struct EuclideanClusterOptions {
  double distance = 0.01;  ///< points at most this far apart are of one cluster [m]
  int min_size = 100;      ///< smaller clusters are left out [points]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("distance", self.distance, "m", "points at most this far apart are of one cluster");
    visit("min_size", self.min_size, "points", "smaller clusters are left out");
  }
  /// Throws InputError on a value that is not positive.
  void validate() const;
};

/// Clusters by single linkage (Rusu 2009, section 6.2), what most robots cut a table into today:
/// disjoint, ascending, largest first. Throws InputError if a coordinate is not finite.
std::vector<PointIndices> euclidean_clusters(const PointCloud& cloud,
                                             const EuclideanClusterOptions& options = {});

/// The same for every distance, 0.5 to 3 cm in steps of 0.25 cm if none is given; the distance of
/// the options does not count. [m]
BaselineSweep euclidean_sweep(const PointCloud& cloud, const EuclideanClusterOptions& options = {},
                              std::vector<double> distances = {});

}  // namespace symscene
