#pragma once

#include <span>

#include "symscene/physics/convex_parts.hpp"
#include "symscene/physics/physics_world.hpp"
#include "symscene/simulation/tabletop.hpp"

namespace symscene {

/// How objects are dropped onto the table, and when they count as being at rest.
struct DropOptions {
  double spread = 0.16;
  double drop_height = 0.01;
  double upright = 0.6;
  double tilt = radians(3.0);
  double area = 0.32;
  double min_thickness = 0.03;
  double fall_time = 0.8;
  double settle_time = 4.0;
  double still_speed = 0.003;
  double max_penetration = 0.002;
  int attempts = 6;
  ConvexPartsOptions parts;
  PhysicsOptions physics;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("spread", self.spread, "m", at_least(0.0),
          "radius of the disc over which objects are dropped");
    visit("drop_height", self.drop_height, "m", above(0.0),
          "height of the lowest point of a dropped object above the objects below it");
    visit("upright", self.upright, "", between(0.0, 1.0),
          "share of the objects dropped as modelled; the others have a random orientation");
    visit("tilt", self.tilt, "rad", at_least(0.0),
          "standard deviation of the tilt of objects dropped upright");
    visit("area", self.area, "m", above(0.0), "radius beyond which an object has fallen off");
    visit("min_thickness", self.min_thickness, "m", at_least(0.0),
          "least extent of the thinnest model that is used");
    visit("fall_time", self.fall_time, "s", above(0.0),
          "longest simulated time before the next object is dropped");
    visit("settle_time", self.settle_time, "s", above(0.0),
          "longest simulated time after the last object was dropped");
    visit("still_speed", self.still_speed, "m/s", above(0.0),
          "largest speed of any point of an object at rest");
    visit("max_penetration", self.max_penetration, "m", above(0.0),
          "largest penetration of an object at rest into another or the table");
    visit("attempts", self.attempts, "", at_least(1), "drops of each object before it is left out");
    visit("parts", self.parts);
    visit("physics", self.physics);
  }
  /// Throws InputError if a value is out of its range or area is not above spread.
  void validate() const;
};

/// Chooses models at random and drops them onto the table one after the other, the largest first,
/// until they are at rest; models without colours are painted. An object that falls off, keeps
/// rolling or penetrates another is dropped again and, after `attempts` drops, left out with a
/// warning in the result. The number of objects, the seed and the frame are those of `tabletop`; a
/// model is used twice only if there are too few. No object has a supporter, as many rest on
/// several.
/// Throws InputError if an option is out of range, no model can be used, or this build has no
/// physics.
Tabletop drop_tabletop(std::span<const ObjectModel> models, const TabletopOptions& tabletop,
                       const DropOptions& options);

/// The objects `settle_time` after they were released at `poses` (T_table_object, one per model),
/// wherever they are then. The world is the table's frame: z = 0 is the table. Throws InputError if
/// an option is out of range or this build has no physics.
Tabletop settle(std::span<const ObjectModel> models, std::span<const Eigen::Isometry3d> poses,
                const DropOptions& options = {});

}  // namespace symscene
