#pragma once

#include <optional>

#include "symscene/tabletop/table_scene.hpp"

namespace symscene {

/// What a user tells about the table of a scene; by default nothing. World frame.
struct KnownTable {
  std::optional<Plane> plane = {};  ///< the table itself, with a unit normal
  bool absent = false;              ///< there is no table: all that is seen is taken
  bool any_up = false;  ///< the camera was not held upright: accept a table of any orientation

  /// The same, and what the cameras tell (prior_of()).
  TablePrior with(TablePrior from_cameras) const;
};

}  // namespace symscene
