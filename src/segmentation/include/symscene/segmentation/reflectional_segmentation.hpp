#pragma once

#include "symscene/segmentation/hypothesis.hpp"
#include "symscene/segmentation/neighborhood_options.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"

namespace symscene {

struct ReflectionalSegmentationOptions {
  CorrespondenceOptions matching;
  double min_angle = radians(10.0);
  double max_angle = radians(45.0);
  double min_occlusion = 0.01;
  double max_occlusion = 0.03;
  double full_weight_angle = radians(45.0);
  double zero_weight_angle = radians(80.0);
  double background_weight = 2.0;
  double edge_factor = 5.0;
  double pair_weight = 1.0;
  double min_support_share = 0.5;
  NeighborhoodOptions neighborhood;
  HypothesisBounds bounds{0.3, 0.005, 0.3, 200};

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("matching", self.matching);
    visit("min_angle", self.min_angle, "rad", between(0.0, std::numbers::pi),
          "the symmetry residual of a point is 0 for angles between matched normals up to this "
          "(Eq. 4.6)");
    visit("max_angle", self.max_angle, "rad", between(0.0, std::numbers::pi),
          "the symmetry residual of a point is 1 for angles between matched normals from this on "
          "(Eq. 4.6)");
    visit("min_occlusion", self.min_occlusion, "m", at_least(0.0),
          "the occlusion residual of a point is 0 if its image is at most this deep in free space "
          "(Eq. 4.7)");
    visit("max_occlusion", self.max_occlusion, "m", at_least(0.0),
          "the occlusion residual of a point is 1 if its image is at least this deep in free space "
          "(Eq. 4.7)");
    visit("full_weight_angle", self.full_weight_angle, "rad", between(0.0, std::numbers::pi),
          "a point whose normal is this close to the plane's normal has full weight as evidence "
          "for the object (section 4.3.1.2)");
    visit("zero_weight_angle", self.zero_weight_angle, "rad", between(0.0, std::numbers::pi),
          "a point whose normal is this far from the plane's normal has none, unless it belongs to "
          "the segment that proposed the plane (section 4.3.1.2)");
    visit("background_weight", self.background_weight, "", Range{0.0, 1000.0, false, true},
          "weight of the affinity to the background (Eq. 4.9)");
    visit("edge_factor", self.edge_factor, "", Range{0.0, 1000.0, false, true},
          "weight of the edges of the surface graph, λ (Eq. 4.1)");
    visit("pair_weight", self.pair_weight, "", at_least(0.0),
          "weight of the edge between a point and its symmetric neighbour, before λ (section "
          "4.3.2)");
    visit("min_support_share", self.min_support_share, "", between(0.0, 1.0),
          "a hypothesis is kept only if it holds this share of the segment that proposed its plane "
          "(section 4.3.3)");
    visit("neighborhood", self.neighborhood);
    visit("bounds", self.bounds);
  }
  /// Throws InputError if a field is out of its range, a range is empty, or pair_weight times
  /// edge_factor is not below 8000.
  void validate() const;
};

/// Cuts out the points that are consistent with each reflection plane (sections 4.3, 4.3.1.2),
/// refits the plane to them, cuts once more and computes the residuals (section 4.3.3). Hypotheses
/// are in the order of their candidates; the result is the same for any number of threads. Throws
/// InputError if an option is invalid.
SegmentedHypotheses segment_reflectional(const ObservedSurface& surface,
                                         const std::vector<ReflectionalCandidate>& candidates,
                                         const PlaneFitOptions& fit,
                                         const ReflectionalSegmentationOptions& options = {});

}  // namespace symscene
