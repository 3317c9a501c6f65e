#include "clutter/object_bodies.hpp"

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/solid.hpp"

namespace symscene {
namespace {

double mass_of(const ObjectModel& model, double density) {
  const double volume = solid_properties(model.mesh).volume;
  if (!(volume > 0.0))
    throw InputError(model.name, "a closed mesh with its outside counter-clockwise", "no volume");
  return density * volume;
}

}  // namespace

std::vector<ConvexParts> parts_of_objects(std::span<const PlacedObject> objects,
                                          const ConvexPartsOptions& options) {
  std::vector<ConvexParts> parts(objects.size());
  parallel_for_each(objects.size(), [&](std::size_t i) {
    parts[i] = convex_parts(objects[i].object.mesh, options);
  });
  return parts;
}

std::vector<WeighedBody> bodies_of_objects(std::span<const PlacedObject> objects,
                                           std::span<const ConvexParts> parts, double density) {
  std::vector<WeighedBody> bodies;
  for (std::size_t i = 0; i < objects.size(); ++i)
    bodies.push_back({&parts[i], mass_of(objects[i].object, density)});
  return bodies;
}

}  // namespace symscene
