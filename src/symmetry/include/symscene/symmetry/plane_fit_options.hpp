#pragma once

#include <numbers>

#include "symscene/core/options.hpp"
#include "symscene/core/types.hpp"

namespace symscene {

/// When the reflection of a point counts as another point (section 3.5.3).
struct CorrespondenceOptions {
  double max_distance = 0.01;
  double max_angle = radians(45.0);
  double min_plane_distance = 0.01;
  bool fold_thin_walls = true;
  double min_fold_angle = radians(135.0);

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("max_distance", self.max_distance, "m", above(0.0),
          "greatest distance between a reflected point and its correspondence (section 3.5.3)");
    visit("max_angle", self.max_angle, "rad", above_up_to(0.0, std::numbers::pi),
          "greatest angle between their normals (section 3.5.3)");
    visit("min_plane_distance", self.min_plane_distance, "m", at_least(0.0),
          "points nearer to the plane correspond to themselves and are ignored");
    visit("fold_thin_walls", self.fold_thin_walls, "", any_value(),
          "opposite normals correspond: both faces of a wall thinner than a voxel");
    visit("min_fold_angle", self.min_fold_angle, "rad", between(0.0, std::numbers::pi),
          "angles above it are folded where fold_thin_walls is set");
  }
  void validate() const { check_fields(*this); }
};

/// Options of the iterative fit of a reflection plane.
struct PlaneFitOptions {
  CorrespondenceOptions matching{.max_distance = 0.008};
  int max_iterations = 20;
  double angle_tolerance = radians(0.05);
  double distance_tolerance = 1e-4;
  double turn_damping = 1e-5;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("matching", self.matching);
    visit("max_iterations", self.max_iterations, "", at_least(1),
          "limit of rounds of matching and solving (section 3.5.3)");
    visit("angle_tolerance", self.angle_tolerance, "rad", above(0.0),
          "the fit ends when a step turns the plane by less and moves it by less than "
          "distance_tolerance");
    visit("distance_tolerance", self.distance_tolerance, "m", above(0.0),
          "the fit ends when a step moves the plane by less and turns it by less than "
          "angle_tolerance");
    visit("turn_damping", self.turn_damping, "m^2", above(0.0),
          "added per match to the normal equations of turns: those that the matches leave open "
          "stay small (Eq. 3.7)");
  }
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
