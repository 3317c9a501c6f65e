#include "symscene/tabletop/view_scene.hpp"

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

PointCloud moved(PointCloud cloud, const Eigen::Isometry3d& T) {
  if (T.matrix().isIdentity(0.0)) return cloud;
  const Eigen::Isometry3f motion = T.cast<float>();
  cloud.positions = (cloud.positions * motion.linear().transpose()).eval();
  cloud.positions.rowwise() += motion.translation().transpose();
  cloud.normals = (cloud.normals * motion.linear().transpose()).eval();
  return cloud;
}

}  // namespace

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
  made.built = timer.time("find table", [&] {
    return build_scene(moved(made.points.cloud, view.T_world_camera), made.occupancy, known,
                       options.scene);
  });
  made.stages = timer.stages();
  return made;
}

ViewScene view_scene(const DepthView& view, const ViewSceneOptions& options) {
  return view_scene(view, prior_of({{view.frame.time, view.T_world_camera}}), options);
}

}  // namespace symscene
