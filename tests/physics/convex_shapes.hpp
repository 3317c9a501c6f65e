#pragma once

#include "symscene/physics/convex_parts.hpp"

namespace symscene::testing {

constexpr double cube_edge = 0.04;  // [m]

/// The corners of a box around the origin of its own frame. [m]
inline ConvexParts box(double x, double y, double z) {
  Points corners(8, 3);
  for (int k = 0; k < 8; ++k) {
    corners.row(k) << static_cast<float>(k & 1 ? 0.5 * x : -0.5 * x),
        static_cast<float>(k & 2 ? 0.5 * y : -0.5 * y),
        static_cast<float>(k & 4 ? 0.5 * z : -0.5 * z);
  }
  return {corners};
}

inline ConvexParts cube() { return box(cube_edge, cube_edge, cube_edge); }

inline Eigen::Isometry3d at(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

}  // namespace symscene::testing
