#include "oriented_input.hpp"

#include "symscene/core/error.hpp"

namespace symscene {

void require_oriented(const PointCloud& cloud) {
  if (cloud.normals.rows() != cloud.positions.rows())
    throw InputError("point cloud", "a normal for every point", "none");
  if (!cloud.positions.allFinite() || !cloud.normals.allFinite())
    throw InputError("point cloud", "finite coordinates and normals", "a NaN or infinite one");
}

}  // namespace symscene
