#pragma once

#include "symscene/baselines/baseline_sweep.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

struct FelzenszwalbOptions {
  double k = 3.0;
  int neighbors = 8;
  double radius = 0.01;
  int merge_size = 500;
  int min_size = 100;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("k", self.k, "", above(0.0), "preference for large segments (0.5 to 7 in table 4.2)");
    visit("neighbors", self.neighbors, "points", at_least(1),
          "nearest neighbours that each point is joined to");
    visit("radius", self.radius, "m", above(0.0), "largest distance of such a neighbour");
    visit("merge_size", self.merge_size, "points", at_least(0),
          "smaller segments join a neighbour (m_size of Karpathy et al. 2013)");
    visit("min_size", self.min_size, "points", at_least(1),
          "smaller segments without a neighbour are left out");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

/// Segments of a cloud with normals by the graph segmentation of Felzenszwalb and Huttenlocher
/// (2004): disjoint and ascending, the largest first. Weights are those of Karpathy, Miller and
/// Fei-Fei (2013, Eq. 1): 1 − n₁·n₂ where the surface is concave, its square where it is convex.
/// Throws InputError if an option is out of range, or a coordinate or a normal is missing or not
/// finite.
std::vector<PointIndices> felzenszwalb_segments(const PointCloud& cloud,
                                                const FelzenszwalbOptions& options = {});

/// The same for every k, by default 0.5 to 7 in steps of 0.5 (table 4.2). The k in the options is
/// not used.
BaselineSweep felzenszwalb_sweep(const PointCloud& cloud, const FelzenszwalbOptions& options = {},
                                 std::vector<double> ks = {});

}  // namespace symscene
