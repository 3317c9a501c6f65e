#include "symscene/workflow/live_scene.hpp"

#include "symscene/pipeline/pipeline.hpp"
#include "symscene/workflow/scene_input.hpp"

namespace symscene {

LiveOptions::LiveOptions() {
  tracked.reconstruction.tsdf.max_contradicted_looks = 5.0;
  tracked.reconstruction.tracking.max_disagreement = 0.15;
}

LiveScene::LiveScene(const CameraIntrinsics& camera, const LiveOptions& options,
                     std::optional<Sensor> sensor)
    : pipeline_(options.pipeline),
      tracked_(camera, options.tracked, sensor),
      identities_(options.identity) {
  pipeline_.validate();
}

void LiveScene::look_at(std::span<const DepthFrame> frames, bool is_tracked) {
  tracked_.look_at(frames, is_tracked);
}

void LiveScene::use(const SensorChoice& sensor) { tracked_.use(sensor); }

FrameReport LiveScene::add(const DepthFrame& frame,
                           const std::optional<Eigen::Isometry3d>& T_world_camera, PoseUse use) {
  return tracked_.add(frame, T_world_camera, use);
}

LiveSnapshot LiveScene::snapshot(const KnownTable& table) const {
  return {tracked_.frames(), tracked_.scene(table)};
}

LiveUpdate LiveScene::update(const LiveSnapshot& snapshot, const StageTimer::OnBegin& on_begin) {
  const Scene& scene = snapshot.scene.built.scene;
  LiveUpdate update{
      snapshot.frames,
      scene.cloud.empty() ? nothing_found(scene) : segment_scene(scene, pipeline_, on_begin),
      {}};
  update.identified = identities_.identify(update.result);
  return update;
}

}  // namespace symscene
