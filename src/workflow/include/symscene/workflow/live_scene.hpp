#pragma once

#include "symscene/core/stage_timer.hpp"
#include "symscene/workflow/live_options.hpp"
#include "symscene/workflow/object_identities.hpp"
#include "symscene/workflow/tracked_scene.hpp"

namespace symscene {

/// The objects after some frames.
struct LiveUpdate {
  std::size_t frames = 0;        ///< that it is made of, with lost ones
  SegmentationResult result;     ///< world frame
  IdentifiedObjects identified;  ///< which of its objects are those of the updates before
};

/// A scene of moving frames as a LiveScene hands it to the segmentation.
struct LiveSnapshot {
  std::size_t frames = 0;
  SweepScene scene;
};

/// Objects of a scene while its frames arrive: add() each frame, ask for objects() at any time.
/// Objects keep their numbers from update to update.
///
/// To segment beside the frames, one thread adds frames and takes a snapshot() between two of them,
/// another runs update() on it: update() does not touch the model, the others do not touch what is
/// known of objects. The same frames and updates give the same bits for any number of threads.
class LiveScene {
 public:
  /// Throws InputError if an option is out of its range.
  explicit LiveScene(const CameraIntrinsics& camera, const LiveOptions& options = {},
                     std::optional<Sensor> sensor = std::nullopt);

  /// As TrackedScene::look_at() and TrackedScene::use().
  void look_at(std::span<const DepthFrame> frames, bool is_tracked = true);
  void use(const SensorChoice& sensor);

  /// Locates a frame and fuses it. Throws InputError as Reconstruction::add().
  FrameReport add(const DepthFrame& frame,
                  const std::optional<Eigen::Isometry3d>& T_world_camera = std::nullopt,
                  PoseUse use = PoseUse::exact);

  std::size_t frames() const { return tracked_.frames(); }
  const Trajectory& cameras() const { return tracked_.cameras(); }

  /// The scene of the frames so far. Throws InputError as TrackedScene::scene().
  LiveSnapshot snapshot(const KnownTable& table = {}) const;

  /// Segments a snapshot and numbers its objects. Throws InputError as segment_scene().
  LiveUpdate update(const LiveSnapshot& snapshot, const StageTimer::OnBegin& on_begin = {});

  /// The objects of the frames so far: update() of snapshot().
  LiveUpdate objects(const KnownTable& table = {}) { return update(snapshot(table)); }

 private:
  PipelineOptions pipeline_;
  TrackedScene tracked_;
  ObjectIdentities identities_;
};

}  // namespace symscene
