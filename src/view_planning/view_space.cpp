#include "view_space.hpp"

#include "core/surface_sampling.hpp"
#include "voxel_walk.hpp"

namespace symscene {
namespace {

Box box_of(const SegmentationResult& result) {
  Box box = bounding_box(result.cloud.positions);
  for (const ObjectSurface& surface : result.surfaces) {
    if (surface.mesh.vertices.rows() == 0) continue;
    const Box own = bounding_box(surface.mesh.vertices);
    box.min = box.min.cwiseMin(own.min);
    box.max = box.max.cwiseMax(own.max);
  }
  return box;
}

}  // namespace

VoxelCell cell_of(const VoxelFrame& frame, std::size_t voxel) {
  return {voxel % frame.row_length(), voxel % frame.slice_length() / frame.row_length(),
          voxel / frame.slice_length()};
}

std::size_t voxel_at(const VoxelFrame& frame, const Eigen::Vector3f& point) {
  const Eigen::Array3f at = (point - frame.origin).array() / frame.resolution;
  if (!(at >= 0.0F).all() || !(at < frame.size.array().cast<float>()).all()) return no_voxel;
  const Eigen::Array3i cell = at.cast<int>();
  return static_cast<std::size_t>(cell.z()) * frame.slice_length() +
         static_cast<std::size_t>(cell.y()) * frame.row_length() +
         static_cast<std::size_t>(cell.x());
}

ViewSpace::ViewSpace(const KnownScene& scene, const NextViewOptions& options)
    : knows_space_(scene.occupancy != nullptr),
      table_(scene.result.table),
      grid_(rasterize(knows_space_ ? *scene.occupancy : OccupancyMap{},
                      box_of(scene.result).padded(static_cast<float>(options.margin)),
                      options.max_voxels)),
      solid_(grid_.states.size(), 0) {
  for (std::size_t i = 0; i < grid_.states.size(); ++i)
    solid_[i] = grid_.states[i] == VoxelState::occupied ? 1 : 0;
  for (const ObjectSurface& surface : scene.result.surfaces) mark_surface(surface.mesh);
  for (Index i = 0; i < scene.result.cloud.size() && !knows_space_; ++i)
    mark(scene.result.cloud.position(i));
}

void ViewSpace::mark(const Eigen::Vector3f& point) {
  const std::size_t voxel = voxel_at(grid_.frame, point);
  if (voxel != no_voxel) solid_[voxel] = 1;
}

/// Samples are so dense that no ray passes between their voxels but at grazing incidence.
void ViewSpace::mark_surface(const TriangleMesh& mesh) {
  const PointCloud samples =
      sample_surface_at(mesh, 0.5 * static_cast<double>(grid_.frame.resolution));
  for (Index i = 0; i < samples.size(); ++i) mark(samples.position(i));
}

bool ViewSpace::can_hold_camera(const Eigen::Vector3f& place) const {
  if (table_ && table_->signed_distance(place.cast<double>()) < 0.0) return false;
  const std::size_t voxel = voxel_at(grid_.frame, place);
  if (voxel == no_voxel) return true;
  return !is_solid(voxel) && (!knows_space_ || grid_.states[voxel] == VoxelState::free);
}

bool ViewSpace::sees(const Eigen::Vector3f& camera, const Eigen::Vector3f& place) const {
  for (VoxelWalk walk(grid_.frame, place, camera - place);
       walk.is_inside() && walk.distance() < 1.0F; walk.advance()) {
    if (is_solid(walk.voxel())) return false;
  }
  return true;
}

}  // namespace symscene
