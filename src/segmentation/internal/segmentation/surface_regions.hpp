#pragma once

#include <map>
#include <span>
#include <utility>
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

/// Regions that cover a cloud, and their borders. Merging them pair by pair, the strongest border
/// first, gives a tree of parts: the surface split along concave borders at every scale. Objects
/// that touch meet in a concave border, so that each is a node of the tree (the convexity criterion
/// of Stein et al. 2014 without a threshold, the tree of Arbelaez et al. 2011).
class SurfaceRegions {
 public:
  using Borders = std::map<std::pair<Index, Index>, RegionBorder>;

  /// `regions` are disjoint and hold every point of a cloud of `points`; `borders` are by pairs of
  /// regions a < b. Throws InputError if an option is invalid.
  SurfaceRegions(std::size_t points, std::vector<PointIndices> regions, const Borders& borders,
                 const SurfacePartsOptions& options);

  /// The nodes of the tree of at least `min_size` points, as ascending indices: first the regions,
  /// then the merged regions, in order.
  std::vector<PointIndices> parts() const;

  /// The nodes of at least `min_size` points that exist when merging stops at the given weakness of
  /// a border, at each of several: partitions of the surface at several scales.
  std::vector<PointIndices> parts_at(std::span<const double> weaknesses) const;

  /// The weakness of the weakest border that joins two large parts of a proposal, in [0, 1]: 0 for
  /// a smooth surface, towards 1 for two objects that touch. `points` are the proposal's,
  /// ascending, as in the functions below.
  double seam(std::span<const Index> points) const;

  /// The share of a proposal's points in its largest connected component of the regions that it
  /// holds.
  double unity(std::span<const Index> points) const;

  /// The mean weakness of the borders between the regions that a proposal holds and all others, in
  /// [0, 1]; 1 if there is none.
  double rim(std::span<const Index> points) const;

 private:
  struct Meeting {
    Index a = 0, b = 0;  ///< regions, a < b
    RegionBorder border;
  };

  /// The nodes of the tree, first the regions, and the weakness at which each appears and ends.
  struct Tree {
    std::vector<PointIndices> points;
    std::vector<double> joined_at, consumed_at;
  };

  /// The regions that belong to a proposal, ascending, and how many of its points each holds.
  struct Held {
    static constexpr Index none = ~Index{0};

    std::vector<Index> regions;
    std::vector<std::size_t> counts;
    std::vector<Index> place;  ///< one per region of the cloud, into `regions`, or none

    bool contains(Index region) const { return place[region] != none; }
  };

  Tree tree() const;
  Held held_by(std::span<const Index> points) const;
  void erase_small(std::vector<PointIndices>& parts) const;

  SurfacePartsOptions options_;
  std::vector<PointIndices> regions_;
  std::vector<Index> region_of_;  ///< one per point
  std::vector<Meeting> meetings_;
  std::vector<std::vector<Index>> meetings_of_;  ///< one list per region, into meetings_
};

/// The smooth regions of region growing; a border is as weak as the edges of the surface graph
/// across it on average. `edges` is the surface graph of `cloud`, `neighbors` are those of region
/// growing. Throws InputError if an option is invalid.
SurfaceRegions smooth_regions(const PointCloud& cloud, const std::vector<WeightedEdge>& edges,
                              const NeighborLists& neighbors,
                              const SurfacePartsOptions& options = {});

/// The patches of the surface (surface_patches()); a border is as weak as the folds between patches
/// across it on average, 1 for a fold of a right angle. Throws InputError if an option is invalid.
SurfaceRegions patch_regions(const PointCloud& cloud, const std::vector<WeightedEdge>& edges,
                             const SurfacePartsOptions& options = {});

}  // namespace symscene
