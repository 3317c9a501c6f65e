#pragma once

#include <optional>
#include <vector>

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
    const std::optional<std::size_t> voxel = voxel_of(point);
    if (!voxel) return true;
    if (grid_.states[*voxel] == VoxelState::free) return false;
    return owner_at(point) != object;
  }

  /// Whether no seen point of an object lies in or beside space that was observed.
  bool is_outside(const SurfaceSamples& samples) const;

 private:
  std::optional<std::size_t> voxel_of(const Eigen::Vector3f& point) const;
  int owner_at(const Eigen::Vector3f& point) const;
  std::size_t coarse_index(const Eigen::Vector3i& coarse) const;
  Eigen::Vector3i coarse_of(const Eigen::Vector3f& point) const;
  void claim(const SurfaceSamples& samples, int owner, float reach,
             std::vector<std::uint16_t>& nearest);

  const OccupancyGrid& grid_;
  Eigen::Vector3i coarse_size_;
  std::vector<std::int16_t> owner_;  ///< per coarse voxel: an object, or −1
};

}  // namespace symscene
