#pragma once

#include "symscene/core/scene.hpp"

namespace symscene {

/// The listed symmetries of an object, by ascending residual.
struct SymmetryLists {
  std::vector<ObjectAxis> rotational;
  std::vector<ObjectPlane> reflectional;
};

/// The symmetries of an object whose surface is a box or a cylinder: those that are listed, moved
/// onto the planes and the axis of the class within `same_angle` of them [rad], and those of the
/// class that are not listed. Planes of a box whose place an end that is hidden leaves open are
/// not added. Those that are added have the share of the points that the class does not explain as
/// residual, until it is measured. Planes through an axis that is added follow from it and are not
/// listed. Lists of other classes are as they were.
SymmetryLists with_symmetries_of_class(SymmetryLists listed, const ObjectClass& symmetry_class,
                                       double same_angle);

}  // namespace symscene
