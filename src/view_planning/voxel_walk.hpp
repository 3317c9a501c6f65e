#pragma once

#include "symscene/occupancy/occupancy_grid.hpp"

namespace symscene {

/// Visits the voxels of a grid along a ray in their order (Amanatides and Woo 1987).
class VoxelWalk {
 public:
  /// `direction` need not have unit length: distances are multiples of it.
  VoxelWalk(const VoxelFrame& frame, const Eigen::Vector3f& origin,
            const Eigen::Vector3f& direction);

  /// Whether the walk is in the grid.
  bool is_inside() const { return is_inside_; }
  /// The voxel in which the walk is.
  std::size_t voxel() const { return index_; }
  /// How far along the ray the voxel is entered; 0 in the voxel of the origin.
  float distance() const { return entered_; }
  /// Goes on to the next voxel.
  void advance();

 private:
  std::size_t index_ = 0;
  bool is_inside_ = false;
  float entered_ = 0.0F;
  Eigen::Array3i cell_, size_, step_;
  Eigen::Array3f next_, spacing_;  ///< distance to the next face along each axis, and between faces
  Eigen::Array<std::ptrdiff_t, 3, 1> stride_;
};

}  // namespace symscene
