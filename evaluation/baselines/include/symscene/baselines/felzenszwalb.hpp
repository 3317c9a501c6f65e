#pragma once

#include "symscene/baselines/baseline_sweep.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

struct FelzenszwalbOptions {
  double k = 3.0;        ///< preference for large segments (0.5 to 7 in table 4.2)
  int neighbors = 8;     ///< each point is joined to so many of its nearest
  double radius = 0.01;  ///< within this [m]
  int merge_size = 500;  ///< smaller segments join a neighbour (m_size of Karpathy et al.) [points]
  int min_size = 100;    ///< what has no neighbour and is smaller is left out [points]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("k", self.k, "", "preference for large segments");
    visit("neighbors", self.neighbors, "points", "each point is joined to so many of its nearest");
    visit("radius", self.radius, "m", "but to none farther than this");
    visit("merge_size", self.merge_size, "points", "smaller segments join a neighbour");
    visit("min_size", self.min_size, "points", "smaller segments are left out");
  }
  /// Throws InputError on a value that is not positive.
  void validate() const;
};

/// An undirected edge and how unlike its ends are.
struct DissimilarEdge {
  Index a = 0;
  Index b = 0;
  float weight = 0.0F;
};

/// The label of every node, that of the lowest node of its component: the graph segmentation of
/// Felzenszwalb and Huttenlocher (2004). Two components become one if the least weight between them
/// is at most Int(C) + k / |C| of either, Int(C) being the greatest weight of its minimum spanning
/// tree; then, by the same order of edges, components smaller than `merge_size` join their
/// neighbours. Ties of weight go to the lower nodes.
std::vector<Index> segment_graph(std::size_t nodes, std::vector<DissimilarEdge> edges, double k,
                                 int merge_size);

/// Segments of a cloud with normals by that algorithm: disjoint, ascending, largest first. Weights
/// are those of Karpathy, Miller and Fei-Fei (2013, Eq. 1): 1 − n₁·n₂ where the surface bends
/// inwards, its square where it bends outwards. Throws InputError if a coordinate or a normal is
/// missing or not finite.
std::vector<PointIndices> felzenszwalb_segments(const PointCloud& cloud,
                                                const FelzenszwalbOptions& options = {});

/// The same for every k, 0.5 to 7 in steps of 0.5 if none is given (table 4.2); the k of the
/// options does not count.
BaselineSweep felzenszwalb_sweep(const PointCloud& cloud, const FelzenszwalbOptions& options = {},
                                 std::vector<double> ks = {});

}  // namespace symscene
