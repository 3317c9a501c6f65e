#pragma once

#include "symscene/segmentation/hypothesis.hpp"
#include "symscene/segmentation/neighborhood_options.hpp"
#include "symscene/symmetry/rotational_detection.hpp"

namespace symscene {

struct RotationalSegmentationOptions {
  double min_angle = radians(0.0);
  double max_angle = radians(15.0);
  double min_occlusion = 0.005;
  double max_occlusion = 0.03;
  double full_weight_angle = radians(30.0);
  double background_weight = 0.5;
  double edge_factor = 2.0;
  double max_refinement = radians(5.0);
  double min_component = 0.1;
  NeighborhoodOptions neighborhood;
  HypothesisBounds bounds{0.03, 0.015, 0.3, 100};

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("min_angle", self.min_angle, "rad", between(0.0, std::numbers::pi / 2),
          "the symmetry residual of a point is 0 for angles between its normal and the plane of "
          "axis and point up to this (Eq. 4.2)");
    visit("max_angle", self.max_angle, "rad", between(0.0, std::numbers::pi / 2),
          "the symmetry residual of a point is 1 for angles between its normal and the plane of "
          "axis and point from this on (Eq. 4.2)");
    visit("min_occlusion", self.min_occlusion, "m", at_least(0.0),
          "the occlusion residual of a point is 0 if its images are at most this deep in free "
          "space (Eq. 4.3)");
    visit("max_occlusion", self.max_occlusion, "m", at_least(0.0),
          "the occlusion residual of a point is 1 if an image is at least this deep in free space "
          "(Eq. 4.3)");
    visit("full_weight_angle", self.full_weight_angle, "rad",
          above_up_to(0.0, std::numbers::pi / 2),
          "a point whose normal is this far from the axis has full weight as evidence; the weight "
          "falls to zero where both are parallel (section 4.3.1.1)");
    visit("background_weight", self.background_weight, "", Range{0.0, 1000.0, false, true},
          "weight of the affinity to the background (Eq. 4.5)");
    visit("edge_factor", self.edge_factor, "", Range{0.0, 1000.0, false, true},
          "weight of the edges of the surface graph, λ (Eq. 4.1)");
    visit("max_refinement", self.max_refinement, "rad", at_least(0.0),
          "an axis refitted to its hypothesis may turn by this at most; otherwise the detected "
          "axis stays (section 4.3)");
    visit("min_component", self.min_component, "", between(0.0, 1.0),
          "connected components of a hypothesis below this share of the largest are dropped "
          "(section 4.3)");
    visit("neighborhood", self.neighborhood);
    visit("bounds", self.bounds);
  }
  /// Throws InputError if a field is out of its range or a range is empty.
  void validate() const;
};

/// Cuts out the points that are consistent with each rotation axis (sections 4.3, 4.3.1.1), refits
/// the axis to them, cuts once more and computes the residuals with the detector's options (section
/// 4.3.3). One hypothesis per candidate, in their order, possibly empty; the result is the same for
/// any number of threads. Throws InputError if an option is invalid.
std::vector<Hypothesis> segment_rotational(const ObservedSurface& surface,
                                           const std::vector<RotationalCandidate>& candidates,
                                           const RotationalDetectionOptions& detection,
                                           const RotationalSegmentationOptions& options = {});

}  // namespace symscene
