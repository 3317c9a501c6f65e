#pragma once

#include "symscene/baselines/baseline_sweep.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Sizes and checks are those that did best on simulated tables (docs/decisions.md), weights those
/// of the authors' example in PCL.
struct LccpOptions {
  double concavity_tolerance = radians(10.0);  ///< β: bends inwards up to this are convex [rad]
  double voxel_size = 0.005;                   ///< [m]
  double seed_spacing = 0.025;                 ///< of the supervoxels [m]
  double spatial_importance = 1.0;             ///< how supervoxels grow; colour does not count
  double normal_importance = 4.0;
  double smoothness = 0.1;          ///< steps higher than so many voxels part surfaces
  bool extended_convexity = false;  ///< a common neighbour has to be convex with both
  bool sanity_check = true;         ///< supervoxels that touch in a point alone are not neighbours
  int min_size = 200;               ///< smaller segments are left out [points]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("concavity_tolerance", self.concavity_tolerance, "rad",
          "bends inwards up to this are convex");
    visit("voxel_size", self.voxel_size, "m", "edge of the voxels");
    visit("seed_spacing", self.seed_spacing, "m", "distance of the supervoxels");
    visit("spatial_importance", self.spatial_importance, "", "weight of distance in supervoxels");
    visit("normal_importance", self.normal_importance, "", "weight of normals in supervoxels");
    visit("smoothness", self.smoothness, "voxels", "higher steps part surfaces");
    visit("extended_convexity", self.extended_convexity, "",
          "a common neighbour has to be convex with both");
    visit("sanity_check", self.sanity_check, "",
          "supervoxels that touch in a point alone are not neighbours");
    visit("min_size", self.min_size, "points", "smaller segments are left out");
  }
  /// Throws InputError if a size, a weight or the smoothness is negative or nothing, seeds are
  /// closer than voxels or the tolerance is outside [0, π].
  void validate() const;
};

/// Whether this build has PCL, which does the work.
bool has_lccp();

/// Locally convex connected patches (Stein et al. 2014) on supervoxels (Papon et al. 2013), as PCL
/// has them: disjoint, ascending, largest first. Normals are those of the cloud. Throws InputError
/// if there is no PCL in this build, or a coordinate or a normal is missing or not finite.
std::vector<PointIndices> lccp_segments(const PointCloud& cloud, const LccpOptions& options = {});

/// The same for every β, 10° to 70° in steps of 5° if none is given (table 4.2), on one set of
/// supervoxels; the tolerance of the options does not count. [rad]
BaselineSweep lccp_sweep(const PointCloud& cloud, const LccpOptions& options = {},
                         std::vector<double> tolerances = {});

}  // namespace symscene
