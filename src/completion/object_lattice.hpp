#pragma once

#include <optional>

#include "convex_bound.hpp"
#include "point_field.hpp"
#include "symscene/completion/object_surface.hpp"

namespace symscene {

/// The nodes around an object, and what they have in common. In the object's frame, z up.
struct ObjectLattice {
  NodeGrid grid;
  Box box;             ///< of the points and their projections onto the base
  float base = 0.0F;   ///< height of the table or of the object's lowest points [m]
  float reach = 0.0F;  ///< of the mean over points [m]
  ConvexBound bound;
  std::vector<float> in_bound;  ///< bound.distances() of the nodes [m]
  NearestPoints nearest;

  /// Nodes that are farther outside of the convex bound take no part. [m]
  float margin() const { return 2.0F * grid.spacing; }
};

/// `points` and `table` are in the object's frame; there is at least one point.
ObjectLattice object_lattice(const SurfacePoints& points, const std::optional<Plane>& table,
                             const ObjectSurfaceOptions& options);

}  // namespace symscene
