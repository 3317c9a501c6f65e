#pragma once

#include "symscene/core/geometry.hpp"
#include "symscene/core/options.hpp"

namespace symscene {

/// Options of the hierarchy of smooth regions (Stein et al. 2014, Arbelaez et al. 2011).
struct SurfacePartsOptions {
  double smooth_angle = radians(10.0);
  double min_smooth_fraction = 0.5;
  int fragment = 20;
  int min_size = 60;
  double min_seam_share = 0.1;
  double min_region_share = 0.5;
  double patch_size = 0.02;
  double bend_cost = 4.0;
  int patch_rounds = 3;
  double max_patch_gap = 1.75;
  double gap_edges = 3.0;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("smooth_angle", self.smooth_angle, "rad", strictly_between(0.0, std::numbers::pi),
          "largest angle between the normals of neighbours in a smooth region (section 3.5.1)");
    visit("min_smooth_fraction", self.min_smooth_fraction, "", between(0.0, 1.0),
          "a point extends its region only if this share of its unassigned neighbours is smooth "
          "(section 3.5.1)");
    visit("fragment", self.fragment, "points", at_least(0.0),
          "smaller regions are merged before all others (Arbelaez et al. 2011)");
    visit("min_size", self.min_size, "points", at_least(1.0),
          "smaller parts are not proposed (Arbelaez et al. 2011)");
    visit("min_seam_share", self.min_seam_share, "", between(0.0, 0.5),
          "a border counts as a seam of a proposal if both sides hold this share of its points "
          "(Stein et al. 2014)");
    visit("min_region_share", self.min_region_share, "", between(0.0, 1.0),
          "a region belongs to a proposal that holds this share of the region's points (Stein "
          "et al. 2014)");
    visit("patch_size", self.patch_size, "m", above(0.0),
          "spacing of the patches whose folds propose parts and score seams (Papon et al. 2013)");
    visit("bend_cost", self.bend_cost, "", at_least(0.0),
          "a point whose normal is at a right angle to a patch's is farther from it by this many "
          "times the distance along the surface (Papon et al. 2013)");
    visit("patch_rounds", self.patch_rounds, "", between(1.0, 100.0),
          "rounds in which points are assigned to patches; more change few points");
    visit(
        "max_patch_gap", self.max_patch_gap, "patches", at_least(0.0),
        "patches whose centres are nearer than this many times patch_size are adjacent even if no "
        "edge joins them");
    visit("gap_edges", self.gap_edges, "edges", above(0.0),
          "edges that a border across such a gap counts as; few, so that borders without a gap "
          "outweigh it");
  }
  /// Throws InputError if a field is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
