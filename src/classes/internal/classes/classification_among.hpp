#pragma once

#include "symscene/classes/classification.hpp"

namespace symscene {

/// The class of an object among others, as classify() finds it: an object that surfaces of others
/// carry does not stand on the table, so that the table is not the end of its height. `others`:
/// points near the object that are not its own, with unit normals. World frame. [m]
ObjectClass classify_among(const ClassifiedObject& object, const PointCloud& others,
                           const ClassOptions& options);

}  // namespace symscene
