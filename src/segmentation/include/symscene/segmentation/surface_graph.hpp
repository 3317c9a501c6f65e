#pragma once

#include "symscene/core/neighbors.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

struct SurfaceGraphOptions {
  int neighbors = 8;
  double radius = 0.01;
  double convex_sigma = 2.0;
  double concave_sigma = 0.15;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("neighbors", self.neighbors, "points", at_least(1.0),
          "number of nearest points that each point is joined to (section 4.3.2)");
    visit("radius", self.radius, "m", above(0.0),
          "longest edge of the surface graph (section 4.3.2)");
    visit("convex_sigma", self.convex_sigma, "", above(0.0),
          "decay of the edge weight where the surface is convex, σ_convex (Eq. 4.10)");
    visit("concave_sigma", self.concave_sigma, "", above(0.0),
          "decay of the edge weight where the surface is concave, σ_concave (Eq. 4.10)");
  }
  /// Throws InputError on a value that is not positive.
  void validate() const { check_fields(*this); }
};

/// The edges of the adjacency graph of a cloud with unit normals, a < b, each once and ascending,
/// weighted by exp(−(1 − n₁·n₂)/σ) (Eq. 4.10, corrected): weak where the surface is concave, as it
/// is between two objects. Convex means (n₁ − n₂) · (p₁ − p₂) > 0, the symmetric form of the test
/// in the text.
std::vector<WeightedEdge> surface_graph(const PointCloud& cloud,
                                        const SurfaceGraphOptions& options = {});

}  // namespace symscene
