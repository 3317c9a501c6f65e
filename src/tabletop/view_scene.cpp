#include "symscene/tabletop/view_scene.hpp"

#include "core/rigid_motion.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
ViewScene view_scene(const DepthView& view, const TablePrior& known,
                     const ViewSceneOptions& options) {
  options.validate();
  StageTimer timer;
  ViewScene made;
  made.points =
      timer.time("unproject", [&] { return unproject(view.frame, view.camera, options.points); });
  if (made.points.cloud.empty())
    throw InputError("depth image", "a surface that the camera faces", "none");
  made.occupancy = OccupancyVolume(options.occupancy);
  timer.time("map space",
             [&] { made.occupancy.integrate(view.frame, view.camera, view.T_world_camera); });
  const auto build = [&](const PointCloud& points_world) {
    return build_scene(points_world, made.occupancy, known, options.scene);
  };
  const PointCloud& points = made.points.cloud;
  const bool is_at_origin = view.T_world_camera.matrix().isIdentity(0.0);
  made.built = timer.time("find table", [&] {
    return is_at_origin ? build(points) : build(transformed(points, view.T_world_camera));
  });
  made.stages = timer.stages();
  return made;
}

ViewScene view_scene(const DepthView& view, const ViewSceneOptions& options) {
  return view_scene(view, prior_of({{view.frame.time, view.T_world_camera}}), options);
}

}  // namespace symscene
