#pragma once

#include <optional>
#include <vector>

#include "grasping/nearest_owner.hpp"
#include "symscene/core/types.hpp"
#include "target.hpp"

namespace symscene {

/// Occupied and never-seen space, and to which object's surroundings it belongs. Where an object
/// hides the space around it from the camera, its closed surface says what is there: space that was
/// not seen and lies nearer to one object than to others, within a reach, is no obstacle for a hand
/// that grasps this object.
class UnknownSpace {
 public:
  /// `objects` have one entry per object of the scene, `others` are further obstacles. Keeps a
  /// reference to `grid`.
  UnknownSpace(const OccupancyGrid& grid, const std::vector<SurfaceSamples>& objects,
               const SurfaceSamples& others, float reach);

  /// Whether a hand that grasps `object` must not be at this point.
  bool blocks(const Eigen::Vector3f& point, int object) const {
    const std::optional<Eigen::Array3i> voxel = voxel_of(point);
    if (!voxel) return true;
    return state_at(*voxel) != VoxelState::free && owner_at(*voxel) != object;
  }

  /// Whether no seen point of an object lies in or beside space that was observed.
  bool is_outside(const SurfaceSamples& samples) const;

 private:
  using Voxels = std::vector<Eigen::Array3i>;

  static constexpr int coarseness = 2;  ///< voxels of the grid per coarse one, along each axis

  std::optional<Eigen::Array3i> voxel_of(const Eigen::Vector3f& point) const;
  VoxelState state_at(const Eigen::Array3i& voxel) const;
  int owner_at(const Eigen::Array3i& voxel) const;
  /// The coarse voxels that hold samples, in the order of these.
  Voxels coarse_voxels(const SurfaceSamples& samples) const;
  /// Bounds the coarse voxels within a radius of the claimed ones. False if there are none.
  bool bound(const std::vector<Voxels>& claims, int radius);

  const OccupancyGrid& grid_;
  Eigen::Array3i coarse_low_ = Eigen::Array3i::Zero();  ///< the first coarse voxel with an owner
  Eigen::Array3i coarse_size_ = Eigen::Array3i::Zero();
  /// Per coarse voxel; owners are the objects, then their number for others.
  std::vector<NearestOwner::Claim> nearest_;
};

}  // namespace symscene
