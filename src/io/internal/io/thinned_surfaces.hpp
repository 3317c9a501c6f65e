#pragma once

#include <span>
#include <vector>

#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// Surfaces with fewer triangles, and how much that changed them.
struct ThinnedSurfaces {
  std::vector<TriangleMesh> meshes;
  std::size_t triangles = 0;  ///< of all
  double usual_error = 0.0;   ///< bound that 99 % of the vertices of each surface keep [m]
  double error = 0.0;         ///< greatest distance of a vertex from the thinned surface [m]
};

/// Surfaces with at most `max_triangles` together, each with a share as of its area; of 60 at
/// least, so that many surfaces may exceed it. Vertices must be finite.
ThinnedSurfaces thinned_surfaces(std::span<const TriangleMesh> surfaces, Index max_triangles);

/// The distance of a point from a triangle. [m]
double distance_to_triangle(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                            const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace symscene
