#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "symscene/core/types.hpp"

namespace symscene {

/// A convex polygon, counter-clockwise. [m]
using Footprint = std::vector<Eigen::Vector2d>;

/// The convex hull of the points seen from above.
Footprint convex_outline(const Points& points);

Footprint moved(const Footprint& footprint, double yaw, const Eigen::Vector2d& offset);

/// A lower bound on the gap between two footprints, exact where an edge faces the gap; negative if
/// they overlap. [m]
double separation(const Footprint& a, const Footprint& b);

}  // namespace symscene
