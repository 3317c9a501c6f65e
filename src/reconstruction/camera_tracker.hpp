#pragma once

#include <optional>
#include <span>

#include "keyframes.hpp"
#include "reconstruction/camera_tracking.hpp"
#include "reconstruction/tsdf_volume.hpp"
#include "stage_clock.hpp"

namespace symscene {

/// Locates the frames of a sequence in the model: follows the camera with a constant-velocity
/// model, checks each pose against the agreement of earlier frames, and searches a lost camera at
/// its last pose and at similar keyframes.
class CameraTracker {
 public:
  /// The volume and the clock must outlive it.
  CameraTracker(const TsdfVolume& volume, const TrackingOptions& options,
                const MeasurementOptions& sensor, StageClock& clock)
      : volume_(&volume), clock_(&clock), options_(options), sensor_(sensor), keyframes_(options) {}

  struct Located {
    TrackingResult tracking;
    bool relocalized = false;
  };
  /// The pose of a frame in a model that is not empty, tracked from `guess` or else from the motion
  /// model. `is_prior`: the pose is known as well as that, and no other is searched.
  Located locate(const Measurement& measurement, const std::optional<Eigen::Isometry3d>& guess,
                 bool is_prior = false);

  /// The frame's pose is accepted and the frame is part of the model. `confirmed` if tracking has
  /// converged against an earlier model: otherwise the motion model is reset.
  void accept(const Measurement& measurement, const TrackingResult& tracking, bool confirmed);

  /// The frame's pose is unknown: the motion model is reset.
  void lose();

 private:
  TrackingResult follow(const Measurement& measurement,
                        const std::optional<Eigen::Isometry3d>& guess, bool is_prior);
  TrackingResult search(const Measurement& measurement);
  bool agrees(const TrackingResult& result) const;
  TrackingResult best_around(const Measurement& measurement, const ModelView& view);
  ModelView predict(const CameraIntrinsics& camera, const Eigen::Isometry3d& T_world_camera);
  ModelView predict_at_last(const CameraIntrinsics& camera);
  ModelView smoothed_view(const CameraIntrinsics& camera, const Eigen::Isometry3d& T_world_camera,
                          std::span<const float> otherwise);
  TrackingResult track(const Measurement& measurement, const ModelView& view,
                       const Eigen::Isometry3d& T_world_guess, const TrackingOptions& options,
                       bool is_prior = false);

  const TsdfVolume* volume_;
  StageClock* clock_;
  TrackingOptions options_;
  MeasurementOptions sensor_;
  Keyframes keyframes_;
  Eigen::Isometry3d T_world_last_ = Eigen::Isometry3d::Identity();
  std::vector<float> last_depth_;  ///< of the frame at T_world_last_ [m]
  std::optional<ModelView> view_;  ///< of the model from T_world_last_, once it is needed
  Eigen::Isometry3d T_last_next_ = Eigen::Isometry3d::Identity();  ///< constant-velocity model
  double disagreement_ = options_.initial_disagreement;  ///< running mean of 1 − agreement
  bool lost_ = false;
};

}  // namespace symscene
