#pragma once

#include <span>

#include "symscene/simulation/settling.hpp"

namespace symscene {

/// How a table is furnished for picks.
struct PickTableOptions {
  TabletopOptions tabletop = default_tabletop();
  DropOptions drop = default_drop();

  template <class Self, class Visit>
  static void visit_fields(Self& self, Visit&& visit) {
    visit("tabletop", self.tabletop);
    visit("drop", self.drop);
  }
  /// A table of 0.8 by 0.8 m above a floor.
  static TabletopOptions default_tabletop();
  /// Objects lie within 0.3 m of its middle, where the included robots reach.
  static DropOptions default_drop();
  /// Throws InputError if a value is out of its range.
  void validate() const;
};

/// A furnished table before a robot. The world is the table's frame: its middle is the origin, z
/// points up.
struct PickTable {
  Tabletop tabletop;
  double density = 400.0;      ///< of the objects [kg/m³]
  ConvexPartsOptions parts{};  ///< of their convex parts
};

/// Drops `models` onto a table, or arranges household objects on it if there is none. Throws
/// InputError if an option is out of range, no model can be used, or this build has no physics.
PickTable furnish_pick_table(std::span<const ObjectModel> models, const PickTableOptions& options);

}  // namespace symscene
