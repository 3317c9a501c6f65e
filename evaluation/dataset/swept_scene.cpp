#include "symscene/dataset/swept_scene.hpp"

#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr const char* exact_poses = "exact";

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

FusedPoses add_frames(const Tabletop& tabletop, const SweepOptions& sweep, bool exact,
                      Reconstruction& reconstruction, SweptScene& result, StageTimer& timer) {
  using Clock = std::chrono::steady_clock;
  FusedPoses poses;
  std::optional<Eigen::Isometry3d> T_world_first;
  std::chrono::duration<double> tracking{0.0};
  const Clock::time_point start = Clock::now();
  capture_sweep(tabletop, sweep, [&](const DepthFrame& frame, const Eigen::Isometry3d& pose) {
    const Clock::time_point begin = Clock::now();
    ++result.frames;
    if (!T_world_first) T_world_first = pose;
    std::optional<Eigen::Isometry3d> known;
    if (exact) known = T_world_first->inverse() * pose;
    const FrameReport report = reconstruction.add(frame, known);
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

BuiltScene scene_of(const TriangleMesh& surface, const Reconstruction& reconstruction,
                    const Trajectory& tracked, const SceneBuildingOptions& options) {
  return build_scene({surface.vertices, surface.normals, surface.colors},
                     reconstruction.occupancy(), prior_of(tracked), options);
}

/// Tracks and fuses the frames.
void make_of_frames(const Tabletop& tabletop, const SweepOptions& sweep,
                    const SweptSceneOptions& options, SweptScene& result, StageTimer& timer) {
  Reconstruction reconstruction(sweep.camera.intrinsics(), options.reconstruction);
  const FusedPoses poses =
      add_frames(tabletop, sweep, options.poses == exact_poses, reconstruction, result, timer);
  result.fused = poses.estimated.size();
  result.trajectory = trajectory_error(poses.estimated, poses.truth);
  result.T_scene_world = align_poses(poses.estimated, poses.truth);
  result.surface = timer.time("surface", [&] { return reconstruction.surface(); });
  if (result.surface.vertices.rows() != 0) {
    BuiltScene built = timer.time("scene", [&] {
      return scene_of(result.surface, reconstruction, poses.tracked, options.scene);
    });
    if (built.scene.table) result.scene = std::move(built.scene);
  }
  result.truth = timer.time("ground truth", [&] {
    return transfer_truth(tabletop_truth(tabletop), meshes_of(tabletop), result.scene.cloud,
                          result.T_scene_world, options.truth);
  });
}

/// Makes the scene of the only frame, in the frame of its camera.
void make_of_view(const Tabletop& tabletop, const SweepOptions& sweep,
                  const SweptSceneOptions& options, SweptScene& result, StageTimer& timer) {
  SensorFrame seen;
  timer.time("render", [&] {
    capture_sensor_frames(tabletop, sweep,
                          [&](double, SensorFrame&& only) { seen = std::move(only); });
  });
  result.T_scene_world = seen.T_world_camera.inverse();
  result.frames = result.fused = 1;
  const CameraIntrinsics camera = sweep.camera.intrinsics();
  const ViewScene view =
      view_scene({{0.0, seen.depth, seen.colors}, camera},
                 {options.view, options.reconstruction.occupancy, options.scene});
  for (const StageTime& stage : view.stages) timer.add(stage.stage, stage.seconds);
  result.surface = view_mesh(view.points, options.view);
  if (view.built.scene.table) result.scene = view.built.scene;
  result.truth = timer.time("ground truth", [&] {
    return view_truth(tabletop_truth(tabletop), seen, camera, result.scene.cloud, options.truth);
  });
}

}  // namespace

void SweptSceneOptions::validate() const {
  check_fields(*this);
  if (poses != exact_poses && poses != "tracked")
    throw InputError("poses", "tracked or exact", fmt::format("\"{}\"", poses));
}

SweptScene reconstruct_sweep(const Tabletop& tabletop, const SweepOptions& sweep,
                             const SweptSceneOptions& options) {
  options.validate();
  SweptScene result;
  StageTimer timer;
  const auto make = sweep.camera.frames == 1 ? make_of_view : make_of_frames;
  make(tabletop, sweep, options, result, timer);
  result.stages = timer.stages();
  return result;
}

}  // namespace symscene
