#pragma once

#include <optional>

#include "symscene/core/normal_estimation.hpp"
#include "symscene/core/options.hpp"
#include "symscene/occupancy/distance_field.hpp"

namespace symscene {

/// Options of outward_vote().
struct OutwardVoteOptions {
  double step = 0.02;
  double up_weight = 1e-3;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("step", self.step, "m", above(0.0),
          "distance from the surface at which free space is compared on both sides (Hoppe et al. "
          "1992)");
    visit("up_weight", self.up_weight, "m", at_least(0.0),
          "weight of the upward direction, which decides where free space is not known (Hoppe et "
          "al. 1992)");
  }
  /// Throws InputError if a field is out of its range.
  void validate() const { check_fields(*this); }
};

/// A vote for the sign of estimated normals: outwards is where space is free and, where that is not
/// known, upwards (away from the table, or +z without one). Refers to `field`. Throws InputError if
/// an option is invalid.
OutwardVote outward_vote(const DistanceField& field, const std::optional<Plane>& table,
                         const OutwardVoteOptions& options = {});

}  // namespace symscene
