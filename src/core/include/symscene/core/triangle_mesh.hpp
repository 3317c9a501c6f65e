#pragma once

#include "symscene/core/types.hpp"

namespace symscene {

/// A triangle mesh.
struct TriangleMesh {
  Points vertices;  ///< V×3 [m]
  Eigen::Matrix<Index, Eigen::Dynamic, 3, Eigen::RowMajor>
      triangles;   ///< T×3 indices, counter-clockwise from outside
  Colors colors;   ///< V×3, or 0×3
  Points normals;  ///< V×3 unit vectors that point out of the surface, or 0×3
};

}  // namespace symscene
