#pragma once

#include <optional>

#include "core/random.hpp"
#include "symscene/simulation/object_model.hpp"

namespace symscene {

enum class ObjectKind { box, can, lying_can, bowl, bottle, cup, toy };
inline constexpr int object_kind_count = 7;

const char* to_string(ObjectKind kind);

/// A kind as often as a household has it.
ObjectKind random_object_kind(Random& random);

/// A round hollow that is open to the top and in which small things can stand.
struct Cavity {
  double radius = 0.0;  ///< of its flat floor; the hollow gets no narrower above it [m]
  double floor = 0.0;   ///< height of the floor [m]
};

/// An object of a household, named for its kind: it stands on z = 0, about the z axis.
struct HouseholdObject : ObjectModel {
  std::vector<Eigen::Vector2d>
      footprint;            ///< convex outline seen from above, counter-clockwise [m]
  double height = 0.0;      ///< [m]
  double top_radius = 0.0;  ///< of a disc on its flat top, 0 where it has none [m]
  std::optional<Cavity> cavity;
};

/// An object of random size, proportions and colours. `scale` makes it smaller (below 1) or bigger.
HouseholdObject make_household_object(ObjectKind kind, Random& random, double scale = 1.0);

}  // namespace symscene
