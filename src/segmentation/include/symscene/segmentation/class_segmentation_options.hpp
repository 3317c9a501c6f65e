#pragma once

#include <numbers>

#include "symscene/core/options.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// Options of the hypotheses of symmetry classes (section 4.7).
struct ClassSegmentationOptions {
  bool enabled = false;
  int max_seeds = 25;
  double min_seed_score = 0.1;
  int fit_points = 300;
  double max_distance = 2.5;
  double min_angle = radians(15.0);
  double max_angle = radians(40.0);
  double background_weight = 1.0;
  double edge_factor = 2.0;
  double min_component = 0.1;
  double same_object = 0.985;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("enabled", self.enabled, "", any_value(),
          "propose masks by boxes, prisms, cylinders and spheres that are fitted to proposals "
          "(section 4.7)");
    visit("max_seeds", self.max_seeds, "", between(0, 1000),
          "number of the best proposals to which surfaces are fitted");
    visit("min_seed_score", self.min_seed_score, "", between(0.0, 1.0),
          "least score of these proposals");
    visit("fit_points", self.fit_points, "points", between(50, 100000),
          "most points of a proposal to which a surface is fitted");
    visit("max_distance", self.max_distance, "", above(1.0),
          "the residual of a point is 1 from this distance from the surface on, over the distance "
          "up to which a surface explains points (classes.tolerance_spacing, tolerance_size)");
    visit("min_angle", self.min_angle, "rad", between(0.0, std::numbers::pi),
          "the residual of a point is 0 for angles between its normal and the surface's up to "
          "this");
    visit("max_angle", self.max_angle, "rad", between(0.0, std::numbers::pi),
          "the residual of a point is 1 for angles between its normal and the surface's from this "
          "on");
    visit("background_weight", self.background_weight, "", Range{0.0, 1000.0, false, true},
          "weight of the affinity to the background, as in Eq. 4.9");
    visit("edge_factor", self.edge_factor, "", Range{0.0, 1000.0, false, true},
          "weight of the edges of the surface graph, λ (Eq. 4.1)");
    visit("min_component", self.min_component, "", between(0.0, 1.0),
          "connected components of a hypothesis below this share of the largest are dropped "
          "(section 4.3)");
    visit("same_object", self.same_object, "IoU", between(0.0, 1.0),
          "a hypothesis that overlaps a proposal more repeats it");
  }
  /// Throws InputError if a field is out of its range or a range is empty.
  void validate() const;
};

}  // namespace symscene
