#pragma once

#include <span>

#include "symscene/physics/physics.hpp"
#include "symscene/simulation/convex_parts_cache.hpp"
#include "symscene/simulation/tabletop.hpp"

namespace symscene {

/// How things are dropped on the table, and what counts as lying still there.
struct DropOptions {
  double spread = 0.16;       ///< radius of the disc that things are dropped over [m]
  double drop_height = 0.01;  ///< of the lowest point over what is below [m]
  double upright = 0.6;       ///< share that is dropped as modelled; others in any orientation
  double tilt = 0.0523599;  ///< standard deviation of the tilt of those dropped upright, 3° [rad]
  double area = 0.32;       ///< radius beyond which a thing has fallen off [m]
  double min_thickness = 0.03;     ///< least extent of the thinnest model that is used [m]
  double fall_time = 0.8;          ///< simulated at most before the next thing falls [s]
  double settle_time = 4.0;        ///< simulated at most after the last has fallen [s]
  double still_speed = 0.003;      ///< of any point of a thing that lies still [m/s]
  double max_penetration = 0.002;  ///< of two things that lie still [m]
  int attempts = 6;                ///< for each thing before it is left out
  ConvexPartsOptions parts;

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("spread", self.spread, "m", "radius of the disc that things are dropped over");
    visit("drop_height", self.drop_height, "m", "height over what is below");
    visit("upright", self.upright, "", "share that is dropped as modelled");
    visit("tilt", self.tilt, "rad", "standard deviation of the tilt of those dropped upright");
    visit("area", self.area, "m", "radius beyond which a thing has fallen off");
    visit("min_thickness", self.min_thickness, "m", "least extent of models that are used");
    visit("fall_time", self.fall_time, "s", "simulated at most before the next thing falls");
    visit("settle_time", self.settle_time, "s", "simulated at most after the last has fallen");
    visit("still_speed", self.still_speed, "m/s", "of any point of a thing that lies still");
    visit("max_penetration", self.max_penetration, "m", "of two things that lie still");
    visit("attempts", self.attempts, "", "drops of each thing before it is left out");
    visit("parts", self.parts);
  }
  void validate() const;
};

/// Drops models that are chosen at random, painted where they have no colours, the largest first,
/// one after the other onto the table until they lie still. What falls off, rolls on or gets stuck
/// in another is dropped again, and after some attempts left out with a warning. The number of
/// objects, the seed and the frame are those of `tabletop`; a model is used twice only when there
/// are too few. No object has a supporter: many rest on several. A cache, in place of
/// `options.parts`, has its own options.
/// Throws InputError if no model is of use, or this build has no physics.
Tabletop drop_tabletop(std::span<const ObjectModel> models, const TabletopOptions& tabletop,
                       const DropOptions& options, ConvexPartsCache* cache = nullptr);

/// Where things are after `settle_time` that are let go at these poses, one a model, wherever that
/// is. World frame, z = 0 the table.
Tabletop settle(std::span<const ObjectModel> models, std::span<const Eigen::Isometry3d> poses,
                const DropOptions& options = {});

}  // namespace symscene
