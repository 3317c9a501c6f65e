#pragma once

#include "symscene/core/options.hpp"

namespace symscene {

/// How far from the segment that proposes a symmetry the points of its object may lie.
struct NeighborhoodOptions {
  double reach = 3.0;
  double margin = 0.3;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit(
        "reach", self.reach, "", at_least(1.0),
        "a cut takes the points within this many radii of the segment that proposed the symmetry, "
        "plus the margin, of its centroid");
    visit("margin", self.margin, "m", at_least(0.0),
          "by how much objects may reach beyond those radii");
  }
  /// Throws InputError if a field is out of its range.
  void validate() const { check_fields(*this); }
};

}  // namespace symscene
