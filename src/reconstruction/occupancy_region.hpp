#pragma once

#include <optional>

#include "occupancy_view.hpp"
#include "symscene/core/oriented_box.hpp"

namespace symscene {

/// Tests cubes of the octree against a box. Without a box all are inside.
class RegionTest {
 public:
  RegionTest(const std::optional<OrientedBox>& region, double resolution);

  /// Which of the centres of the voxels of a cube lie in the box. `code` is the Morton code of its
  /// first voxel.
  Sight inside(std::uint64_t code, int level) const;

 private:
  double resolution_;
  bool bounded_;
  Eigen::Isometry3d T_box_world_;
  Eigen::Vector3d center_;
  Eigen::Vector3d half_;
};

}  // namespace symscene
