#pragma once

#include "symscene/core/neighbors.hpp"
#include "symscene/core/options.hpp"
#include "symscene/core/point_cloud.hpp"

namespace symscene {

struct OversegmentationOptions {
  double fine_angle =
      radians(10.0);  ///< θ₁: normals of neighbours on one smooth surface [rad] (3.5.1)
  double coarse_angle = radians(15.0);  ///< θ₂ [rad] (3.5.1)
  double min_smooth_fraction =
      0.5;  ///< a point grows its segment if so many of its free neighbours are smooth
  double duplicate_overlap = 0.8;  ///< of two segments with more IoU the larger stays
  int min_size = 120;              ///< smaller segments propose no symmetry [points]

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("fine_angle", self.fine_angle, "rad",
          "normals of neighbours on a smooth surface, first run");
    visit("coarse_angle", self.coarse_angle, "rad",
          "normals of neighbours on a smooth surface, second run");
    visit("min_smooth_fraction", self.min_smooth_fraction, "",
          "a point grows its segment if this share of its free neighbours is smooth");
    visit("duplicate_overlap", self.duplicate_overlap, "IoU",
          "of two segments of both runs that overlap more, the larger stays");
    visit("min_size", self.min_size, "points", "smaller segments propose no symmetry");
  }
  /// Throws InputError if an angle is outside (0, π), a share outside [0, 1] or the size below 3.
  void validate() const;
};

/// Smooth surfaces by region growing from the flattest point, at one angle (section 3.5.1): a point
/// adds its smooth neighbours only if at least half of those not yet assigned are smooth, which
/// stops leaks over rounded edges. Segments are disjoint, in the order in which they were grown.
std::vector<PointIndices> grow_regions(const PointCloud& cloud, const NeighborLists& neighbors,
                                       double max_angle, const OversegmentationOptions& options);

/// Smooth surfaces at both angles, duplicates merged, largest first. They may overlap.
std::vector<PointIndices> oversegment(const PointCloud& cloud, const NeighborLists& neighbors,
                                      const OversegmentationOptions& options = {});

}  // namespace symscene
