#include "symscene/core/oriented_box.hpp"

namespace symscene {

Box world_bounds(const OrientedBox& box) {
  Box bounds;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Eigen::Vector3d p = box.min;
    for (unsigned axis = 0; axis < 3; ++axis) {
      if ((corner >> axis) & 1U) p[axis] = box.max[axis];
    }
    const Eigen::Vector3f world = (box.T_world_box * p).cast<float>();
    bounds.min = bounds.min.cwiseMin(world);
    bounds.max = bounds.max.cwiseMax(world);
  }
  return bounds;
}

}  // namespace symscene
