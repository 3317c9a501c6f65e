#include "symscene/workflow/reconstructed_scene.hpp"

#include <utility>

#include "core/rigid_motion.hpp"
#include "symscene/core/stage_timer.hpp"
#include "workflow/plane_fallback.hpp"

namespace symscene {

BuiltScene reconstructed_scene(const ReconstructedModel& model, const KnownTable& table,
                               const SceneBuildingOptions& options) {
  const TriangleMesh& surface = model.surface;
  const PointCloud points{surface.vertices, surface.normals, surface.colors};
  BuiltScene built =
      even_if_plane_misses(table.with(prior_of(model.cameras)), [&](const TablePrior& known) {
        return build_scene(points, model.reconstruction.occupancy(), known, options);
      });
  for (std::string& warning : model.reconstruction.warnings())
    built.scene.warnings.push_back(std::move(warning));
  return built;
}

ReconstructedView reconstructed_view(const DepthView& view, const KnownTable& table,
                                     const ViewSceneOptions& options) {
  const Trajectory cameras{{view.frame.time, view.T_world_camera}};
  ViewScene scene = even_if_plane_misses(
      table.with(prior_of(cameras)),
      [&](const TablePrior& known) { return view_scene(view, known, options); });
  StageTimer timer;
  TriangleMesh surface = timer.time("extract surface", [&] {
    return transformed(view_mesh(scene.points, options.points), view.T_world_camera);
  });
  scene.stages.push_back(timer.stages().back());
  return {std::move(scene), std::move(surface)};
}

}  // namespace symscene
