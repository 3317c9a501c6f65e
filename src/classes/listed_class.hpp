#pragma once

#include "symscene/classes/classification.hpp"

namespace symscene {

/// The class of an object's listed symmetries. Perpendicular planes, and an axis and a plane across
/// it, are fitted in one frame.
ObjectClass class_of_symmetries(const ClassifiedObject& object, const ClassOptions& options);

}  // namespace symscene
