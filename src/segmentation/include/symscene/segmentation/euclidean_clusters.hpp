#pragma once

#include <vector>

#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

struct EuclideanClusterOptions {
  double distance = 0.01;
  int min_size = 100;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("distance", self.distance, "m", above(0.0),
          "points at most this far apart are in one cluster (Rusu 2009, section 6.2)");
    visit("min_size", self.min_size, "points", at_least(1), "smaller clusters are left out");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// Clusters by single linkage (Rusu 2009, section 6.2), the usual segmentation of table-top scenes
/// on robots. The clusters are disjoint and ascending, the largest first. Throws InputError if an
/// option is out of range or a coordinate is not finite.
std::vector<PointIndices> euclidean_clusters(const PointCloud& cloud,
                                             const EuclideanClusterOptions& options = {});

}  // namespace symscene
