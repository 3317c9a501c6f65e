#pragma once

#include <numbers>

#include "symscene/baselines/baseline_sweep.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

/// Sizes and checks are those with the best F on simulated scenes (docs/decisions.md), weights
/// those of the authors' example in PCL.
struct LccpOptions {
  double concavity_tolerance = radians(10.0);
  double voxel_size = 0.005;
  double seed_spacing = 0.025;
  double spatial_importance = 1.0;
  double normal_importance = 4.0;
  double smoothness = 0.1;
  bool extended_convexity = false;
  bool sanity_check = true;
  int min_size = 200;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("concavity_tolerance", self.concavity_tolerance, "rad", between(0.0, std::numbers::pi),
          "angle up to which a concave connection counts as convex (beta of Stein et al. 2014)");
    visit("voxel_size", self.voxel_size, "m", above(0.0), "edge of the voxels");
    visit("seed_spacing", self.seed_spacing, "m", above(0.0), "distance between supervoxel seeds");
    visit("spatial_importance", self.spatial_importance, "", at_least(0.0),
          "weight of the distance in the growth of supervoxels; colour has none");
    visit("normal_importance", self.normal_importance, "", at_least(0.0),
          "weight of the normals in the growth of supervoxels");
    visit("smoothness", self.smoothness, "voxels", at_least(0.0),
          "higher steps between supervoxels separate surfaces");
    visit("extended_convexity", self.extended_convexity, "", any_value(),
          "require a common neighbour that is convex with both supervoxels");
    visit("sanity_check", self.sanity_check, "", any_value(),
          "supervoxels that touch in a single point are not neighbours");
    visit("min_size", self.min_size, "points", at_least(1), "smaller segments are left out");
  }
  /// Throws InputError if a value is out of its range or seed_spacing is below voxel_size.
  void validate() const;
};

/// Whether this build has PCL, which LCCP needs.
bool has_lccp();

/// Locally convex connected patches (Stein et al. 2014) on supervoxels (Papon et al. 2013),
/// computed by PCL with the normals of the cloud. The segments are disjoint and ascending, the
/// largest first. Throws InputError if this build has no PCL, an option is out of range, or a
/// coordinate or a normal is missing or not finite.
std::vector<PointIndices> lccp_segments(const PointCloud& cloud, const LccpOptions& options = {});

/// The same for every tolerance β [rad], by default 10° to 70° in steps of 5° (table 4.2), on one
/// set of supervoxels. The tolerance in the options is not used.
BaselineSweep lccp_sweep(const PointCloud& cloud, const LccpOptions& options = {},
                         std::vector<double> tolerances = {});

}  // namespace symscene
