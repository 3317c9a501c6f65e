#pragma once

#include "symscene/core/neighbors.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

struct SurfaceGraphOptions {
  int neighbors = 8;            ///< each point is joined to so many of its nearest
  double radius = 0.01;         ///< within this [m]
  double convex_sigma = 2.0;    ///< σ_convex (Eq. 4.10)
  double concave_sigma = 0.15;  ///< σ_concave (Eq. 4.10)

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("neighbors", self.neighbors, "points", "each point is joined to so many of its nearest");
    visit("radius", self.radius, "m", "but to none farther than this");
    visit("convex_sigma", self.convex_sigma, "", "how slowly an edge weakens over a convex bend");
    visit("concave_sigma", self.concave_sigma, "",
          "how slowly an edge weakens over a concave bend");
  }
  /// Throws InputError on a value that is not positive.
  void validate() const;
};

/// The edges of the adjacency graph of a cloud, a < b, each once, weighted by Eq. 4.10 (corrected):
/// exp(−(1 − n₁·n₂)/σ), weak where the surface bends inwards, as it does between two objects.
/// Convex is (n₁ − n₂) · (p₁ − p₂) > 0: the test of the text from both ends.
std::vector<WeightedEdge> surface_graph(const PointCloud& cloud,
                                        const SurfaceGraphOptions& options = {});

}  // namespace symscene
