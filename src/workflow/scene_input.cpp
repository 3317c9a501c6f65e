#include "symscene/workflow/scene_input.hpp"

#include <utility>

namespace symscene {

ViewInput view_input(DepthFrame frame, const CameraIntrinsics& camera, const SensorChoice& sensor,
                     const KnownTable& table, const ViewSceneOptions& options) {
  frame = sensor.prepared(std::move(frame), camera);
  ViewSceneOptions used = options;
  used.points.noise = sensor.noise.value_or(used.points.noise);
  Trajectory cameras{{frame.time, Eigen::Isometry3d::Identity()}};
  ViewScene scene = view_scene({frame, camera}, table.with(prior_of(cameras)), used);
  TriangleMesh surface = view_mesh(scene.points, used.points);
  return {std::move(scene), std::move(surface), std::move(cameras), std::move(frame)};
}

SegmentationResult nothing_found(const Scene& scene) {
  SegmentationResult nothing;
  nothing.table = scene.table;
  nothing.warnings = scene.warnings;
  return nothing;
}

}  // namespace symscene
