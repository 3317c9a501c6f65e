#pragma once

#include "symscene/core/options.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"

namespace symscene {

/// How views are compared.
struct NextViewOptions {
  double explained_weight = 0.3;
  double dispute_weight = 0.3;
  double unknown_weight = 0.1;
  double cost_weight = 0.0;
  double min_share = 0.02;
  double max_incidence = radians(75.0);
  double min_depth = 0.2;
  double max_depth = 6.0;
  int samples = 3000;
  int ray_columns = 80;
  double margin = 0.1;
  int max_voxels = 1 << 24;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("explained_weight", self.explained_weight, "", between(0.0, 1.0),
          "weight of inferred surface that is the image of observed surface under an accepted "
          "symmetry; that of other inferred surface is 1");
    visit("dispute_weight", self.dispute_weight, "", between(0.0, 100.0),
          "weight of surface that a rejected hypothesis assigns to another object");
    visit("unknown_weight", self.unknown_weight, "", between(0.0, 100.0),
          "weight of the border of space that was never seen");
    visit("cost_weight", self.cost_weight, "m2", between(0.0, 1e6),
          "gain that a unit of the given costs outweighs; 0: costs count only where they are "
          "infinite");
    visit("min_share", self.min_share, "", between(0.0, 1.0),
          "views stop where the best gain is below this share of the area of all objects");
    visit("max_incidence", self.max_incidence, "rad", above_up_to(0.0, radians(90.0)),
          "greatest angle between a line of sight and the normal of a surface that it shows");
    visit("min_depth", self.min_depth, "m", between(0.0, 100.0),
          "nearer places are not seen: least depth that the camera measures");
    visit("max_depth", self.max_depth, "m", above_up_to(0.0, 100.0),
          "farther places are not seen: greatest depth that the camera measures");
    visit("samples", self.samples, "", between(100, 1000000),
          "places whose visibility is tested: of inferred and disputed surface and of the border");
    visit("ray_columns", self.ray_columns, "", between(8, 4096),
          "rays across an image with which never seen voxels are counted");
    visit("margin", self.margin, "m", between(0.0, 10.0),
          "margin around all points and surfaces within which space is looked at");
    visit("max_voxels", self.max_voxels, "", between(4096.0, 1 << 28),
          "voxels of that space; a larger one gets coarser voxels");
  }
  /// Throws InputError if a value is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
