#include "surface_checks.hpp"
#include "symscene/core/neighbors.hpp"
#include "symscene/core/solid.hpp"
#include "symscene/grasping/planner.hpp"

namespace symscene {
namespace {

GraspObject grasp_object(const SegmentationResult& result, std::size_t i) {
  if (i < result.surfaces.size()) require_moderate_size(result.surfaces[i], i);
  const SceneObject& object = result.objects[i];
  return {select(result.cloud, object.points),
          i < result.surfaces.size() ? result.surfaces[i] : ObjectSurface{},
          object.rotational,
          object.reflectional,
          object.symmetry_class,
          object.solid};
}

/// The points of all objects.
Points points_of_objects(const SegmentationResult& result) {
  PointIndices all;
  for (const SceneObject& object : result.objects)
    all.insert(all.end(), object.points.begin(), object.points.end());
  return select(result.cloud, all).positions;
}

/// The points of the cloud above the table that neither belong to an object nor lie beside one: the
/// latter are mostly borders of the object.
Points other_points(const SegmentationResult& result) {
  constexpr double least_height = 0.01;
  constexpr float border = 0.012F;
  const Points belonging = points_of_objects(result);
  const CellList objects(belonging, border);
  PointIndices others;
  for (Index i = 0; i < result.cloud.size(); ++i) {
    const Eigen::Vector3f position = result.cloud.position(i);
    const bool is_high =
        !result.table || result.table->signed_distance(position.cast<double>()) > least_height;
    if (is_high && objects.nearest(position, border).first == CellList::none) others.push_back(i);
  }
  return select(result.cloud, others).positions;
}

/// The box of everything that could be touched.
Box bounds_of(const SegmentationResult& result) {
  Box box = bounding_box(result.cloud.positions);
  for (const ObjectSurface& surface : result.surfaces) {
    const Box bounds = bounding_box(surface.mesh.vertices);
    box.min = box.min.cwiseMin(bounds.min);
    box.max = box.max.cwiseMax(bounds.max);
  }
  return box;
}

}  // namespace

GraspScene grasp_scene(const SegmentationResult& result, const Scene* scene,
                       const GraspOptions& options) {
  GraspScene grasping;
  for (std::size_t i = 0; i < result.objects.size(); ++i)
    grasping.objects.push_back(grasp_object(result, i));
  grasping.table = result.table;
  grasping.obstacles = other_points(result);
  if (scene != nullptr && scene->occupancy && !result.cloud.empty()) {
    grasping.space = rasterize(*scene->occupancy,
                               bounds_of(result).padded(static_cast<float>(options.space_margin)),
                               options.max_voxels);
  }
  return grasping;
}

}  // namespace symscene
