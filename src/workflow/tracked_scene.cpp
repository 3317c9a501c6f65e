#include "symscene/workflow/tracked_scene.hpp"

#include <utility>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "symscene/workflow/reconstructed_scene.hpp"

namespace symscene {

TrackedScene::TrackedScene(const CameraIntrinsics& camera, const TrackedSceneOptions& options,
                           std::optional<Sensor> sensor)
    : camera_(camera), options_(options), named_(sensor) {
  options_.validate();
}

void TrackedScene::look_at(std::span<const DepthFrame> frames, bool is_tracked) {
  use(choose_sensor(frames, is_tracked, camera_, named_, options_.sensor));
}

void TrackedScene::use(const SensorChoice& sensor) {
  if (sensor_)
    throw InputError("sensor", "to be chosen once, before the first frame is added", "a later one");
  sensor_ = sensor;
  double& tracking_noise = options_.reconstruction.measurement.noise;
  tracking_noise = sensor_->tracking_noise.value_or(tracking_noise);
  options_.view.noise = sensor_->noise.value_or(options_.view.noise);
  reconstruction_.emplace(camera_, options_.reconstruction);
}

FrameReport TrackedScene::add(const DepthFrame& frame,
                              const std::optional<Eigen::Isometry3d>& T_world_camera, PoseUse use) {
  if (!sensor_) look_at({&frame, 1});
  const DepthFrame prepared = sensor_->prepared(frame, camera_);
  FrameReport report = reconstruction_->add(prepared, T_world_camera, use);
  if (frames_++ == 0) first_ = prepared;
  if (report.fused)
    cameras_.push_back({frame.time, report.tracking.T_world_camera});
  else if (lost_++ == 0)
    reason_ = report.tracking.reason;
  return report;
}

TriangleMesh TrackedScene::surface() const {
  return cameras_.empty() ? TriangleMesh{} : reconstruction_->surface();
}

SweepScene TrackedScene::scene(const KnownTable& table) const {
  if (cameras_.empty()) throw InputError("frames", "a frame that can be fused", reason_);
  SweepScene scene = frames_ == 1 ? scene_of_view(table) : scene_of_sweep(table);
  if (lost_ != 0)
    scene.built.scene.warnings.push_back(fmt::format(
        "{} of {} frames are lost and left out, the first because {}", lost_, frames_, reason_));
  return scene;
}

SweepScene TrackedScene::scene_of_view(const KnownTable& table) const {
  const Eigen::Isometry3d& pose = cameras_.front().T_world_camera;
  ReconstructedView made =
      reconstructed_view({first_, camera_, pose}, table,
                         {options_.view, options_.reconstruction.occupancy, options_.scene});
  SweepScene scene{std::move(made.view.built), std::move(made.surface), cameras_, {}};
  if (!scene.built.scene.cloud.empty())
    scene.log_odds = made.view.occupancy.log_odds(scene.built.region);
  return scene;
}

SweepScene TrackedScene::scene_of_sweep(const KnownTable& table) const {
  SweepScene scene{{}, reconstruction_->surface(), cameras_, {}};
  scene.built =
      reconstructed_scene({*reconstruction_, scene.surface, cameras_}, table, options_.scene);
  if (!scene.built.scene.cloud.empty())
    scene.log_odds = reconstruction_->occupancy().log_odds(scene.built.region);
  return scene;
}

}  // namespace symscene
