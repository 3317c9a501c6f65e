#pragma once

#include <numbers>

#include "symscene/core/options.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// Options of the least-squares fit of a rotation axis.
struct AxisFitOptions {
  double residual_scale = radians(15.0);
  double position_noise = 0.003;
  int max_iterations = 30;
  double angle_tolerance = 1e-5;
  double distance_tolerance = 1e-6;
  int max_points = 800;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("residual_scale", self.residual_scale, "rad", strictly_between(0.0, std::numbers::pi / 2),
          "scale of the robust loss: angles well above it count as outliers (Eq. 3.4)");
    visit("position_noise", self.position_noise, "m", at_least(0.0),
          "noise of positions: points not much farther from the axis have a low weight");
    visit("max_iterations", self.max_iterations, "", at_least(1),
          "limit of Levenberg-Marquardt iterations (section 3.5.2)");
    visit("angle_tolerance", self.angle_tolerance, "rad", above(0.0),
          "the fit ends when a step turns the axis by less and moves it by less than "
          "distance_tolerance");
    visit("distance_tolerance", self.distance_tolerance, "m", above(0.0),
          "the fit ends when a step moves the axis by less and turns it by less than "
          "angle_tolerance");
    visit("max_points", self.max_points, "points", at_least(8),
          "larger inputs are subsampled evenly");
  }
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
