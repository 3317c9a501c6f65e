#pragma once

#include <numbers>

#include "symscene/core/options.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// When a surface is a sphere.
struct SphereOptions {
  double max_angle = radians(8.0);
  double max_radius_deviation = 0.05;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_angle", self.max_angle, "rad", between(0.0, std::numbers::pi / 2),
          "upper bound of the mean angle between normals and radii of a sphere");
    visit("max_radius_deviation", self.max_radius_deviation, "", at_least(0.0),
          "upper bound of the standard deviation of radii of a sphere, by their mean");
  }
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
