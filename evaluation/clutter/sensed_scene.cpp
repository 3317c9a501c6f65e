#include "clutter/sensed_scene.hpp"

#include "method_parts.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

const Plane table{Eigen::Vector3d::UnitZ(), -clutter::table_height};
constexpr const char* given_plane = "--plane";  // where build_scene() finds fault with it

DepthFrame scaled(const ClutterView& view, const CameraIntrinsics& camera) {
  DepthFrame frame = view.frame;
  const double scale = depth_scale(view, camera, table);
  for (float& depth : frame.depth) depth = static_cast<float>(static_cast<double>(depth) / scale);
  return frame;
}

Scene scene_of_view(const DepthFrame& frame, const Eigen::Isometry3d& pose, const TablePrior& prior,
                    const ClutterMethodOptions& options) {
  return view_scene({frame, clutter_camera(), pose}, prior, options.view).built.scene;
}

Scene scene_of_views(std::span<const DepthFrame> frames, const Trajectory& poses,
                     const TablePrior& prior, const ClutterMethodOptions& options) {
  Reconstruction reconstruction(clutter_camera(), options.reconstruction);
  for (std::size_t i = 0; i < frames.size(); ++i)
    reconstruction.add(frames[i], poses[i].T_world_camera);
  const TriangleMesh surface = reconstruction.surface();
  if (surface.vertices.rows() == 0) return {};
  return build_scene({surface.vertices, surface.normals, surface.colors},
                     reconstruction.occupancy(), prior, options.view.scene)
      .scene;
}

Scene scene_of(std::span<const ClutterView> views, const ClutterMethodOptions& options) {
  Trajectory poses;
  std::vector<DepthFrame> frames;
  for (const ClutterView& view : views) {
    poses.push_back({view.frame.time, view.T_world_camera});
    frames.push_back(options.table == TableKnowledge::scale ? scaled(view, clutter_camera())
                                                            : view.frame);
  }
  TablePrior prior = prior_of(poses);
  if (options.table != TableKnowledge::none) prior.plane = table;
  return views.size() == 1
             ? scene_of_view(frames.front(), poses.front().T_world_camera, prior, options)
             : scene_of_views(frames, poses, prior, options);
}

}  // namespace

Scene sensed_scene(std::span<const ClutterView> views, const ClutterMethodOptions& options) {
  try {
    return scene_of(views, options);
  } catch (const InputError& error) {
    if (error.where() != given_plane) throw;
    // The scale of the noise can put all that is seen of the table off the plane that is given.
    Scene nothing;
    nothing.warnings.emplace_back("no surface is seen at the table");
    return nothing;
  }
}

}  // namespace symscene
