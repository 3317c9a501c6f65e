#pragma once

#include "symscene/core/types.hpp"

namespace symscene {

/// The diagonal of the box that is narrowest along its first direction, and then along its second:
/// of a box its own diagonal, in any pose. Zero without points. [m]
double tight_box_diagonal(const Points& points);

}  // namespace symscene
