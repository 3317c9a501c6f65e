#pragma once

#include "symscene/simulation/tabletop.hpp"

namespace symscene {

/// A table without objects, in the frame that `options` set: that of the world, or a random one.
Tabletop empty_tabletop(const TabletopOptions& options);

/// The ground truth of a placed object except for its mask. World frame.
TrueObject true_object(const PlacedObject& placed);

}  // namespace symscene
