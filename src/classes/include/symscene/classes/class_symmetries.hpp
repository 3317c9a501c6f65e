#pragma once

#include "symscene/core/scene.hpp"

namespace symscene {

/// The listed symmetries of an object, by ascending residual.
struct SymmetryLists {
  std::vector<ObjectAxis> rotational;
  std::vector<ObjectPlane> reflectional;
};

/// The symmetries of an object and its class: those listed within `same_angle` of one of the class
/// [rad], moved onto it, and those of a fitted box or cylinder that are not listed. Planes parallel
/// to one of the class elsewhere are dropped. Other listed symmetries stay as they are: to drop
/// them lost more true planes than false ones. A plane between ends of which one is hidden keeps
/// its place if it goes through what is seen; such planes of a box are not added. Those that are
/// added have the share of the points that the class does not explain as residual, until it is
/// measured. Planes through an axis that is added follow from it and are not listed. An object
/// without a class keeps its lists.
SymmetryLists with_symmetries_of_class(SymmetryLists listed, const ObjectClass& symmetry_class,
                                       double same_angle);

/// The class with its centre on the listed planes of it between ends of which one is hidden, so
/// that its symmetries in the lists go through it. Lower bounds stay those of what is seen.
ObjectClass centred_on_planes(ObjectClass symmetry_class, const std::vector<ObjectPlane>& listed);

}  // namespace symscene
