#include "pipeline/object_completion.hpp"

#include "core/parallel.hpp"
#include "symscene/completion/object_box.hpp"

namespace symscene {
namespace {

/// The points that span an object: those of its closed surface or, without one, its own.
const Points& extent_of(const CompletedObject& object, const ObjectSurface& surface) {
  return surface.mesh.vertices.rows() != 0 ? surface.mesh.vertices : object.observed.positions;
}

}  // namespace

void complete_objects(const DistanceField& field, const PipelineOptions& options,
                      SegmentationResult& result) {
  result.completed.resize(result.objects.size());
  result.surfaces.resize(result.objects.size());
  std::optional<Eigen::Vector3d> up;
  if (result.table) up = result.table->normal;
  parallel_for_each(result.objects.size(), [&](std::size_t id) {
    SceneObject& object = result.objects[id];
    const auto axes = options.complete_by_symmetry ? object.rotational : std::vector<ObjectAxis>{};
    const auto planes =
        options.complete_by_symmetry ? object.reflectional : std::vector<ObjectPlane>{};
    const PointCloud observed = select(result.cloud, object.points);
    PointCloud& added = result.completed[id];
    added = complete_object(observed, axes, planes, field, options.completion);
    const CompletedObject completed{observed, added, axes, planes};
    object.centroid = centre_of_mass(completed, options.completion);
    ObjectSurface& surface = result.surfaces[id];
    surface = object_surface(completed, {field, result.table}, options.object_surface,
                             options.completion);
    if (surface.mesh.triangles.rows() != 0) object.solid = solid_properties(surface.mesh);
    object.box = object_box(extent_of(completed, surface), object.symmetry_class, up);
  });
}

}  // namespace symscene
