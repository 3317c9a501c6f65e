#pragma once

#include <optional>

#include "core/random.hpp"
#include "symscene/simulation/object_model.hpp"

namespace symscene {

enum class ObjectKind { box, can, lying_can, bowl, bottle, cup, toy };
inline constexpr int object_kind_count = 7;

const char* to_string(ObjectKind kind);

/// A random kind with the frequencies of a household.
ObjectKind random_object_kind(Random& random);

/// A round hollow, open to the top, in which small objects can stand.
struct Cavity {
  double radius = 0.0;  ///< of its flat floor; the hollow is not narrower above [m]
  double floor = 0.0;   ///< height of the floor [m]
};

/// A household object, named for its kind. It stands on z = 0 about the z axis.
struct HouseholdObject : ObjectModel {
  std::vector<Eigen::Vector2d>
      footprint;            ///< convex outline seen from above, counter-clockwise [m]
  double height = 0.0;      ///< [m]
  double top_radius = 0.0;  ///< of a disc on its flat top, 0 without one [m]
  std::optional<Cavity> cavity;
};

/// An object of random size, proportions and colours. `scale` is relative to real
/// sizes.
HouseholdObject make_household_object(ObjectKind kind, Random& random, double scale = 1.0);

}  // namespace symscene
