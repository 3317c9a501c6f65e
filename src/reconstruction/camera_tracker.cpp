#include "camera_tracker.hpp"

#include <limits>

#include "relocalization.hpp"

namespace symscene {
namespace {

/// The stricter bounds of a lost camera.
TrackingOptions when_lost(TrackingOptions options) {
  options.min_overlap = options.relocalize_overlap;
  options.min_inliers = options.relocalize_inliers;
  return options;
}

}  // namespace

CameraTracker::Located CameraTracker::locate(const Measurement& measurement,
                                             const std::optional<Eigen::Isometry3d>& guess) {
  TrackingResult result = follow(measurement, guess);
  const bool followed = result.status != TrackingStatus::lost;
  if (!result.searchable || (followed && !lost_ && agrees(result))) return {result, false};
  // Much of a table looks alike from all sides: a lost camera is placed where it fits best, and
  // only if it fits as well there as earlier frames did.
  TrackingResult found = search(measurement);
  if (found.agreement < result.agreement && followed) found = result;
  if (found.status != TrackingStatus::converged || !agrees(found)) {
    if (followed) result.reason = "the image agrees with the model less than those before it";
    result.status = TrackingStatus::lost;
    return {result, false};
  }
  return {found, lost_};
}

void CameraTracker::accept(const Measurement& measurement, const TrackingResult& tracking,
                           bool confirmed) {
  const Eigen::Isometry3d& pose = tracking.T_world_camera;
  T_last_next_ = confirmed ? T_world_last_.inverse() * pose : Eigen::Isometry3d::Identity();
  if (confirmed) {
    disagreement_ += options_.disagreement_gain * (1.0 - tracking.agreement - disagreement_);
  }
  keyframes_.add(measurement, pose);
  T_world_last_ = pose;
  view_.reset();
  lost_ = false;
}

void CameraTracker::lose() {
  lost_ = true;
  T_last_next_.setIdentity();
}

/// The bound of a lost camera is stricter: half of the measured pixels may show a bare table, which
/// agrees from everywhere.
bool CameraTracker::agrees(const TrackingResult& result) const {
  const double bound =
      lost_ ? options_.relocalize_disagreement_ratio * disagreement_ +
                  options_.relocalize_max_disagreement
            : options_.disagreement_ratio * disagreement_ + options_.max_disagreement;
  return 1.0 - result.agreement <= bound;
}

/// The model as seen from a pose. Smoothed as measured images are: the noise of the model's own
/// normals would add constraints that hold the camera back.
ModelView CameraTracker::predict(const CameraIntrinsics& camera,
                                 const Eigen::Isometry3d& T_world_camera) {
  return clock_->time(StageClock::predict_view, [&] {
    ModelView view = cast_model_view(*volume_, camera, T_world_camera);
    std::vector<float> depth(view.image.pixels.size());
    for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = view.image.pixels[i].depth;
    view.image = find_surface(std::move(depth), camera, sensor_);
    return view;
  });
}

TrackingResult CameraTracker::track(const Measurement& measurement, const ModelView& view,
                                    const Eigen::Isometry3d& T_world_guess,
                                    const TrackingOptions& options) {
  return clock_->time(StageClock::track, [&] {
    return track_camera(measurement, view, T_world_guess, options, sensor_);
  });
}

/// Tracks from the guess; else from the prediction of the motion model and, failing that, from the
/// last pose.
TrackingResult CameraTracker::follow(const Measurement& measurement,
                                     const std::optional<Eigen::Isometry3d>& guess) {
  const CameraIntrinsics& camera = measurement.pyramid.front().camera;
  const TrackingOptions options = lost_ ? when_lost(options_) : options_;
  if (guess) return track(measurement, predict(camera, *guess), *guess, options);
  if (!view_) view_ = predict(camera, T_world_last_);
  const TrackingResult result = track(measurement, *view_, T_world_last_ * T_last_next_, options);
  if (result.status != TrackingStatus::lost) return result;
  const TrackingResult again = track(measurement, *view_, T_world_last_, options);
  return again.status != TrackingStatus::lost ? again : result;
}

/// The best pose around the last one and around similar keyframes.
TrackingResult CameraTracker::search(const Measurement& measurement) {
  TrackingOptions options = when_lost(options_);
  options.max_translation = options.max_rotation = std::numeric_limits<double>::infinity();
  TrackingResult best;
  std::vector<Eigen::Isometry3d> places =
      keyframes_.most_similar(measurement, static_cast<std::size_t>(options_.relocalize_keyframes));
  places.insert(places.begin(), T_world_last_);
  for (const Eigen::Isometry3d& place : places) {
    const ModelView view = predict(measurement.pyramid.front().camera, place);
    const std::vector<Eigen::Isometry3d> starts = clock_->time(StageClock::track, [&] {
      return likely_poses(measurement, view, place, options, sensor_);
    });
    for (const Eigen::Isometry3d& start : starts) {
      TrackingResult result = track(measurement, view, start, options);
      if (result.status != TrackingStatus::converged) continue;
      if (result.agreement > best.agreement) best = std::move(result);
    }
  }
  return best;
}

}  // namespace symscene
