#include "symscene/dataset/swept_scene.hpp"

#include <chrono>
#include <optional>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "symscene/core/frame_rectifier.hpp"

namespace symscene {
namespace {

constexpr const char* exact_poses = "exact";

constexpr int labelled_views = 40;  ///< at most, from which a scene takes its ground truth

/// The poses of the frames that were fused, and what some of them show.
struct FusedFrames {
  Trajectory tracked;
  std::vector<Eigen::Isometry3d> estimated;
  std::vector<Eigen::Isometry3d> truth;
  LabelledSweep labelled;
};

/// Frames as a calibrated camera gives them.
class Rectification {
 public:
  explicit Rectification(const CameraModel* calibration) {
    if (calibration != nullptr) rectifier_.emplace(*calibration);
  }

  SensorFrame operator()(SensorFrame&& seen) const {
    if (!rectifier_) return std::move(seen);
    DepthFrame frame = rectifier_->rectified({0.0, std::move(seen.depth), std::move(seen.colors)});
    seen.depth = std::move(frame.depth);
    seen.colors = std::move(frame.colors);
    seen.objects = rectifier_->rectified_labels(seen.objects, SensorFrame::nothing);
    return std::move(seen);
  }

 private:
  std::optional<FrameRectifier> rectifier_;
};

FusedFrames add_frames(const Tabletop& tabletop, const SweepOptions& sweep, bool exact,
                       const Rectification& rectified, Reconstruction& reconstruction,
                       SweptScene& result, StageTimer& timer) {
  using Clock = std::chrono::steady_clock;
  FusedFrames fused;
  fused.labelled.camera = sweep.camera.intrinsics();
  const int stride = (sweep.camera.frames + labelled_views - 1) / labelled_views;
  std::optional<Eigen::Isometry3d> T_world_first;
  std::chrono::duration<double> tracking{0.0};
  const Clock::time_point start = Clock::now();
  capture_sensor_frames(tabletop, sweep, [&](double time, SensorFrame&& measured) {
    const Clock::time_point begin = Clock::now();
    SensorFrame seen = rectified(std::move(measured));
    DepthFrame frame{time, std::move(seen.depth), std::move(seen.colors)};
    const std::size_t number = result.frames++;
    if (!T_world_first) T_world_first = seen.T_world_camera;
    std::optional<Eigen::Isometry3d> known;
    if (exact) known = T_world_first->inverse() * seen.T_world_camera;
    const FrameReport report = reconstruction.add(frame, known);
    tracking += Clock::now() - begin;
    if (!report.fused) return;
    const Eigen::Isometry3d& T_scene_camera = report.tracking.T_world_camera;
    fused.tracked.push_back({time, T_scene_camera});
    fused.estimated.push_back(T_scene_camera);
    fused.truth.push_back(seen.T_world_camera);
    if (number % static_cast<std::size_t>(stride) == 0)
      fused.labelled.views.push_back(
          {T_scene_camera.inverse(), std::move(frame.depth), std::move(seen.objects)});
  });
  const std::chrono::duration<double> all = Clock::now() - start;
  timer.add("render", (all - tracking).count());
  timer.add("reconstruct", tracking.count());
  return fused;
}

BuiltScene scene_of(const TriangleMesh& surface, const Reconstruction& reconstruction,
                    const Trajectory& tracked, const SceneBuildingOptions& options) {
  return build_scene({surface.vertices, surface.normals, surface.colors},
                     reconstruction.occupancy(), prior_of(tracked), options);
}

/// Tracks and fuses the frames.
void make_of_frames(const Tabletop& tabletop, const SweepOptions& sweep,
                    const SweptSceneOptions& options, const Rectification& rectified,
                    SweptScene& result, StageTimer& timer) {
  Reconstruction reconstruction(sweep.camera.intrinsics(), options.reconstruction);
  const FusedFrames fused = add_frames(tabletop, sweep, options.poses == exact_poses, rectified,
                                       reconstruction, result, timer);
  result.fused = fused.estimated.size();
  result.trajectory = trajectory_error(fused.estimated, fused.truth);
  result.T_scene_world = align_poses(fused.estimated, fused.truth);
  result.surface = timer.time("surface", [&] { return reconstruction.surface(); });
  if (result.surface.vertices.rows() != 0) {
    BuiltScene built = timer.time("scene", [&] {
      return scene_of(result.surface, reconstruction, fused.tracked, options.scene);
    });
    if (built.scene.table) result.scene = std::move(built.scene);
  }
  result.truth = timer.time("ground truth", [&] {
    return sweep_truth(tabletop_truth(tabletop), fused.labelled, result.scene.cloud,
                       result.T_scene_world, options.truth);
  });
}

/// Makes the scene of the only frame, in the frame of its camera.
void make_of_view(const Tabletop& tabletop, const SweepOptions& sweep,
                  const SweptSceneOptions& options, const Rectification& rectified,
                  SweptScene& result, StageTimer& timer) {
  SensorFrame seen;
  timer.time("render", [&] {
    capture_sensor_frames(tabletop, sweep,
                          [&](double, SensorFrame&& only) { seen = rectified(std::move(only)); });
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
                             const SweptSceneOptions& options, const CameraModel* calibration) {
  options.validate();
  SweptScene result;
  StageTimer timer;
  const auto make = sweep.camera.frames == 1 ? make_of_view : make_of_frames;
  make(tabletop, sweep, options, Rectification(calibration), result, timer);
  result.stages = timer.stages();
  return result;
}

}  // namespace symscene
