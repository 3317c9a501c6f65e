#include "symscene/dataset/swept_scene.hpp"

#include <chrono>

namespace symscene {
namespace {

/// The poses of the frames that were fused.
struct FusedPoses {
  Trajectory tracked;
  std::vector<Eigen::Isometry3d> estimated;
  std::vector<Eigen::Isometry3d> truth;
};

std::vector<TriangleMesh> meshes_of(const Tabletop& tabletop) {
  std::vector<TriangleMesh> meshes;
  for (const PlacedObject& placed : tabletop.objects) meshes.push_back(placed.object.mesh);
  return meshes;
}

FusedPoses track(const Tabletop& tabletop, const SweepOptions& sweep,
                 Reconstruction& reconstruction, SweptScene& result, StageTimer& timer) {
  using Clock = std::chrono::steady_clock;
  FusedPoses poses;
  std::chrono::duration<double> tracking{0.0};
  const Clock::time_point start = Clock::now();
  capture_sweep(tabletop, sweep, [&](const DepthFrame& frame, const Eigen::Isometry3d& pose) {
    const Clock::time_point begin = Clock::now();
    ++result.frames;
    const FrameReport report = reconstruction.add(frame);
    tracking += Clock::now() - begin;
    if (!report.fused) return;
    poses.tracked.push_back({frame.time, report.tracking.T_world_camera});
    poses.estimated.push_back(report.tracking.T_world_camera);
    poses.truth.push_back(pose);
  });
  const std::chrono::duration<double> all = Clock::now() - start;
  timer.add("render", (all - tracking).count());
  timer.add("reconstruct", tracking.count());
  return poses;
}

}  // namespace

SweptScene reconstruct_sweep(const Tabletop& tabletop, const SweepOptions& sweep,
                             const SweptSceneOptions& options) {
  options.validate();
  SweptScene result;
  StageTimer timer;
  Reconstruction reconstruction(sweep.camera.intrinsics(), options.reconstruction);
  const FusedPoses poses = track(tabletop, sweep, reconstruction, result, timer);
  result.fused = poses.estimated.size();
  result.trajectory = trajectory_error(poses.estimated, poses.truth);
  result.T_scene_world = align_poses(poses.estimated, poses.truth);
  result.surface = timer.time("surface", [&] { return reconstruction.surface(); });
  if (result.surface.vertices.rows() != 0) {
    timer.time("scene", [&] {
      result.scene = build_scene(result.surface, reconstruction.occupancy(), {},
                                 upward(poses.tracked), options.scene)
                         .scene;
    });
  }
  timer.time("ground truth", [&] {
    result.truth = transfer_truth(tabletop_truth(tabletop), meshes_of(tabletop), result.scene.cloud,
                                  result.T_scene_world, options.truth);
  });
  result.stages = timer.stages();
  return result;
}

}  // namespace symscene
