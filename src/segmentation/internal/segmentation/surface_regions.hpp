#pragma once

#include <span>
#include <vector>

#include "symscene/core/neighbors.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/segmentation/graph_cut.hpp"
#include "symscene/segmentation/surface_parts.hpp"

namespace symscene {

/// The border of two regions: the number of edges across it and their summed weakness.
struct RegionBorder {
  double edges = 0.0;
  double weakness = 0.0;  ///< sum of 1 − weight over the edges

  double bend() const { return weakness / edges; }
  RegionBorder& operator+=(const RegionBorder& other) {
    edges += other.edges;
    weakness += other.weakness;
    return *this;
  }
};

/// Smooth regions that cover a cloud, and their borders. Merging them pair by pair, the strongest
/// border (by mean edge weight) first, gives a tree of parts: the surface split along concave
/// borders at every scale. Objects that touch meet in a concave border, so that each is a node of
/// the tree (the convexity criterion of Stein et al. 2014 without a threshold, the tree of Arbelaez
/// et al. 2011).
class SurfaceRegions {
 public:
  /// `edges` is the surface graph of `cloud`, `neighbors` are those of region growing. Throws
  /// InputError if an option is invalid.
  SurfaceRegions(const PointCloud& cloud, const std::vector<WeightedEdge>& edges,
                 const NeighborLists& neighbors, const SurfacePartsOptions& options = {});

  /// The nodes of the tree of at least `min_size` points, as ascending indices: first the regions,
  /// then the merged regions, in order.
  std::vector<PointIndices> parts() const;

  /// The weakness of the weakest border that joins two large parts of a set, in [0, 1]: 0 for a
  /// smooth surface, towards 1 for two objects that touch. `points` ascend.
  double seam(std::span<const Index> points) const;

 private:
  struct Meeting {
    Index a = 0, b = 0;  ///< regions, a < b
    RegionBorder border;
  };

  SurfacePartsOptions options_;
  std::vector<PointIndices> regions_;
  std::vector<Index> region_of_;  ///< one per point
  std::vector<Meeting> meetings_;
  std::vector<std::vector<Index>> meetings_of_;  ///< one list per region, into meetings_
};

}  // namespace symscene
