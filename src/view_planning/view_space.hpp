#pragma once

#include <optional>
#include <vector>

#include "symscene/view_planning/next_view.hpp"

namespace symscene {

/// The space around the objects, in which lines of sight are followed.
class ViewSpace {
 public:
  ViewSpace(const KnownScene& scene, const NextViewOptions& options);

  const OccupancyGrid& grid() const { return grid_; }
  /// Whether it is known which voxels were seen to be free.
  bool knows_space() const { return knows_space_; }
  /// Whether the voxel is occupied or holds surface, observed or inferred.
  bool is_solid(std::size_t voxel) const { return solid_[voxel] != 0; }
  /// Whether a camera could be there: above the table and, within the grid, in free space.
  bool can_hold_camera(const Eigen::Vector3f& place) const;
  /// Whether nothing solid lies between a place just off a surface and the camera.
  bool sees(const Eigen::Vector3f& camera, const Eigen::Vector3f& place) const;

 private:
  void mark(const Eigen::Vector3f& point);
  void mark_surface(const TriangleMesh& mesh);

  bool knows_space_;
  std::optional<Plane> table_;
  OccupancyGrid grid_;
  std::vector<std::uint8_t> solid_;
};

/// The place of a voxel in the grid along x, y and z.
struct VoxelCell {
  std::size_t x = 0, y = 0, z = 0;
};
VoxelCell cell_of(const VoxelFrame& frame, std::size_t voxel);

/// The index of the voxel that holds a point; no_voxel outside the grid.
constexpr std::size_t no_voxel = ~std::size_t{0};
std::size_t voxel_at(const VoxelFrame& frame, const Eigen::Vector3f& point);

}  // namespace symscene
