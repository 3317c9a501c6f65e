#pragma once

#include <optional>

#include "convex_bound.hpp"
#include "point_field.hpp"

namespace symscene {

/// When an object counts as a vessel with thin walls.
struct ThinWallBounds {
  float max_thickness = 0.012F;  ///< of a wall [m]
  float min_depth = 0.02F;       ///< of a cavity along the normals of its points [m]
  float lowest = 0.0F;           ///< z of points of a cavity; lower ones may be of the table [m]
};

/// A vessel: which points lie inside its cavity, and the thickness of its walls.
struct Vessel {
  std::vector<std::uint8_t> inner;  ///< per point; 1 for those of a sample
  float thickness = 0.0F;           ///< [m]
};

/// The vessel that points show: part of them look into a cavity of their convex hull, and part of
/// these have points that face away on the other side of a thin wall. None for other objects.
std::optional<Vessel> find_vessel(const SurfacePoints& points, const ConvexBound& bound,
                                  const ThinWallBounds& bounds);

/// The distances of the nodes of an object. [m]
struct NodeDistances {
  const std::vector<float>& surface;  ///< signed_distances()
  const std::vector<float>& bound;    ///< ConvexBound::distances()
};

/// Bounds how far a vessel's inside reaches behind its points to the thickness of its walls, where
/// nothing was seen: a hidden part of the cavity is empty, and closed at the convex hull by a wall
/// of that thickness.
void hollow_out(const NodeGrid& grid, const Vessel& vessel, const NearestPoints& nearest,
                const NodeDistances& distances, std::vector<float>& field);

}  // namespace symscene
