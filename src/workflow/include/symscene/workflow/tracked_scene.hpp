#pragma once

#include <optional>
#include <span>
#include <string>

#include "symscene/workflow/known_table.hpp"
#include "symscene/workflow/sensor_choice.hpp"
#include "symscene/workflow/tracked_scene_options.hpp"

namespace symscene {

/// What a scene folder holds of a sweep. World frame.
struct SweepScene {
  BuiltScene built;
  TriangleMesh surface;
  Trajectory cameras;   ///< of the fused frames
  LogOddsMap log_odds;  ///< of the space that the scene maps
};

/// Depth frames of a moving camera that become a scene, frame by frame, as `symscene reconstruct`
/// does it without stitching. A single frame becomes a scene by its own pixels.
class TrackedScene {
 public:
  /// Throws InputError if an option is out of its range.
  explicit TrackedScene(const CameraIntrinsics& camera, const TrackedSceneOptions& options = {},
                        std::optional<Sensor> sensor = std::nullopt);

  /// Chooses the sensor by frames that are spread over the sweep, before the first is added; a
  /// single frame is not tracked. Without this the first frame decides.
  void look_at(std::span<const DepthFrame> frames, bool is_tracked = true);

  /// The same by a choice that is made already.
  void use(const SensorChoice& sensor);

  /// Locates a frame and fuses it. Throws InputError as Reconstruction::add().
  FrameReport add(const DepthFrame& frame,
                  const std::optional<Eigen::Isometry3d>& T_world_camera = std::nullopt,
                  PoseUse use = PoseUse::exact);

  const CameraIntrinsics& camera() const { return camera_; }
  std::size_t frames() const { return frames_; }
  const Trajectory& cameras() const { return cameras_; }
  /// The surface of the fused frames; empty without one.
  TriangleMesh surface() const;

  /// The scene of the frames so far. A warning counts lost frames. If no point is on the given
  /// plane, all that is seen is taken, and a warning says so. Throws InputError if no frame is
  /// fused or the frames show no surface.
  SweepScene scene(const KnownTable& table = {}) const;

 private:
  SweepScene scene_of_view(const KnownTable& table) const;
  SweepScene scene_of_sweep(const KnownTable& table) const;

  CameraIntrinsics camera_;
  TrackedSceneOptions options_;
  std::optional<Sensor> named_;
  std::optional<SensorChoice> sensor_;
  std::optional<Reconstruction> reconstruction_;  ///< once the sensor is known
  DepthFrame first_;
  std::size_t frames_ = 0;
  std::size_t lost_ = 0;
  Trajectory cameras_;
  std::string reason_ = "none was added";  ///< why the first of them is lost
};

}  // namespace symscene
