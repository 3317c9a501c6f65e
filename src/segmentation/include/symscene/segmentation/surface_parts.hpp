#pragma once

#include <span>
#include <vector>

#include "symscene/core/neighbors.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"
#include "symscene/segmentation/graph_cut.hpp"

namespace symscene {

struct SurfacePartsOptions {
  double smooth_angle = radians(10.0);  ///< of normals within one smallest region [rad]
  int fragment = 20;            ///< smaller regions join their likeliest neighbour first [points]
  int min_size = 60;            ///< smaller parts are not proposed [points]
  double min_seam_share = 0.1;  ///< a seam has at least this share of the points on either side

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("smooth_angle", self.smooth_angle, "rad", "of normals within one smallest region");
    visit("fragment", self.fragment, "points", "smaller regions join a neighbour first");
    visit("min_size", self.min_size, "points", "smaller parts are not proposed");
    visit("min_seam_share", self.min_seam_share, "",
          "a seam has at least this share of the points on either side");
  }
  /// Throws InputError on a value out of its range.
  void validate() const;
};

/// What two regions share: the edges between them and how weak these are together.
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

/// Smooth regions that cover a cloud, and the borders at which they meet. Joined pair by pair,
/// those first whose border is strongest on average, they make a tree of parts: the surface taken
/// apart where it bends inwards, at every scale. Objects that touch meet in a concave border, so
/// that each is a part of its own at some scale (the convexity of Stein et al. 2014 without a
/// threshold, the tree of Arbelaez et al. 2011).
class SurfaceRegions {
 public:
  /// `edges` is the surface graph of `cloud`, `neighbors` are those of region growing.
  SurfaceRegions(const PointCloud& cloud, const std::vector<WeightedEdge>& edges,
                 const NeighborLists& neighbors, const SurfacePartsOptions& options = {});

  /// Every set of points that comes up as regions are joined, ascending, the smallest regions
  /// first; sets below the least size are left out.
  std::vector<PointIndices> parts() const;

  /// How weak the border is at which a set of points comes apart into two large pieces, as it is
  /// joined from its regions: 0 for one smooth surface, towards 1 for two things that touch. A
  /// region belongs to the set if most of it does.
  double seam(std::span<const Index> points) const;

 private:
  struct Meeting {
    Index a = 0, b = 0;  ///< regions, a < b
    RegionBorder border;
  };

  SurfacePartsOptions options_;
  std::vector<PointIndices> regions_;
  std::vector<Index> region_of_;  ///< of every point
  std::vector<Meeting> meetings_;
  std::vector<std::vector<Index>> meetings_of_;  ///< of every region, into meetings_
};

}  // namespace symscene
