#pragma once

#include <span>
#include <vector>

#include "symscene/physics/convex_parts.hpp"
#include "symscene/physics/grasp_world.hpp"
#include "symscene/simulation/tabletop.hpp"

namespace symscene {

/// The convex parts of each object, in its frame.
std::vector<ConvexParts> parts_of_objects(std::span<const PlacedObject> objects,
                                          const ConvexPartsOptions& options);

/// The objects as bodies of a density [kg/m³]. `parts` has those of each object and must outlive
/// the bodies. Throws InputError if a mesh encloses no volume.
std::vector<WeighedBody> bodies_of_objects(std::span<const PlacedObject> objects,
                                           std::span<const ConvexParts> parts, double density);

}  // namespace symscene
