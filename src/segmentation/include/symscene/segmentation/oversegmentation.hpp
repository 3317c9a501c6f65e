#pragma once

#include "symscene/core/neighbors.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

struct OversegmentationOptions {
  double fine_angle = radians(10.0);
  double coarse_angle = radians(15.0);
  double min_smooth_fraction = 0.5;
  double duplicate_overlap = 0.8;
  int min_size = 120;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("fine_angle", self.fine_angle, "rad", strictly_between(0.0, std::numbers::pi),
          "largest angle between the normals of smooth neighbours in the first run (θ₁, section "
          "3.5.1)");
    visit("coarse_angle", self.coarse_angle, "rad", strictly_between(0.0, std::numbers::pi),
          "largest angle between the normals of smooth neighbours in the second run (θ₂, section "
          "3.5.1)");
    visit("min_smooth_fraction", self.min_smooth_fraction, "", between(0.0, 1.0),
          "a point extends its segment only if this share of its unassigned neighbours is smooth "
          "(section 3.5.1)");
    visit("duplicate_overlap", self.duplicate_overlap, "IoU", between(0.0, 1.0),
          "of two segments that overlap more, only the larger is kept (section 3.5.1)");
    visit("min_size", self.min_size, "points", at_least(3.0),
          "smaller segments propose no symmetry (section 3.5.1)");
  }
  /// Throws InputError if a field is out of its range.
  void validate() const { check_fields(*this); }
};

/// Smooth segments at both angles without duplicates, largest first. They may overlap.
std::vector<PointIndices> oversegment(const PointCloud& cloud, const NeighborLists& neighbors,
                                      const OversegmentationOptions& options = {});

}  // namespace symscene
