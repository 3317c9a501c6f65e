#include "camera_tracker.hpp"

#include "dominant_plane.hpp"
#include "reconstruction/relocalization.hpp"

namespace symscene {
namespace {

std::vector<float> depths_of(const SurfaceImage& image) {
  std::vector<float> depth(image.pixels.size());
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = image.pixels[i].depth;
  return depth;
}

/// The outcome for a pose that tracking found and that is not accepted, or was lost before.
TrackingResult disagreeing(TrackingResult result) {
  if (result.status != TrackingStatus::lost)
    result.reason = "the image agrees with the model less than those before it";
  result.status = TrackingStatus::lost;
  return result;
}

}  // namespace

CameraTracker::Located CameraTracker::locate(const Measurement& measurement,
                                             const std::optional<Eigen::Isometry3d>& guess,
                                             bool is_prior) {
  if (is_prior) lost_ = false;
  TrackingResult result = follow(measurement, guess, is_prior);
  const bool followed = result.status != TrackingStatus::lost;
  if (!result.searchable || (followed && !lost_ && agrees(result))) return {result, false};
  if (is_prior) return {disagreeing(std::move(result)), false};
  // Much of a table looks alike from all sides: a lost camera is placed where it fits best, and
  // only if it fits as well there as earlier frames did.
  TrackingResult found = search(measurement);
  if (found.agreement < result.agreement && followed) found = result;
  if (found.status != TrackingStatus::converged || !agrees(found)) {
    return {disagreeing(std::move(result)), false};
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
  last_depth_ = depths_of(measurement.pyramid.front());
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
/// normals would bias the alignment towards no motion.
ModelView CameraTracker::predict(const CameraIntrinsics& camera,
                                 const Eigen::Isometry3d& T_world_camera) {
  return smoothed_view(camera, T_world_camera, {});
}

/// The model as seen from the last pose, completed with the frame that was fused there: after few
/// frames the model has cells with unseen corners, which no ray can cross.
ModelView CameraTracker::predict_at_last(const CameraIntrinsics& camera) {
  return smoothed_view(camera, T_world_last_, last_depth_);
}

/// The model as seen from a pose, with the depths of `otherwise` where it shows none.
ModelView CameraTracker::smoothed_view(const CameraIntrinsics& camera,
                                       const Eigen::Isometry3d& T_world_camera,
                                       std::span<const float> otherwise) {
  return clock_->time(StageClock::predict_view, [&] {
    ModelView view = cast_model_view(*volume_, camera, T_world_camera);
    std::vector<float> depth = depths_of(view.image);
    for (std::size_t i = 0; i < otherwise.size(); ++i) {
      if (depth[i] == 0.0F) depth[i] = otherwise[i];
    }
    view.image = find_surface(std::move(depth), camera, sensor_);
    view.has_dominant_plane =
        flatten_dominant_plane(view.image, sensor_.noise, sensor_.dominant_plane);
    return view;
  });
}

TrackingResult CameraTracker::track(const Measurement& measurement, const ModelView& view,
                                    const Eigen::Isometry3d& T_world_guess,
                                    const TrackingOptions& options, bool is_prior) {
  return clock_->time(StageClock::track, [&] {
    const auto track = is_prior ? track_camera_with_prior : track_camera;
    return track(measurement, view, T_world_guess, options, sensor_);
  });
}

/// Tracks from the guess; else from the prediction of the motion model and, failing that, from the
/// last pose.
TrackingResult CameraTracker::follow(const Measurement& measurement,
                                     const std::optional<Eigen::Isometry3d>& guess, bool is_prior) {
  const CameraIntrinsics& camera = measurement.pyramid.front().camera;
  const TrackingOptions options = lost_ ? when_lost(options_) : options_;
  if (guess) return track(measurement, predict(camera, *guess), *guess, options, is_prior);
  if (!view_) view_ = predict_at_last(camera);
  const TrackingResult result = track(measurement, *view_, T_world_last_ * T_last_next_, options);
  if (result.status != TrackingStatus::lost) return result;
  const TrackingResult again = track(measurement, *view_, T_world_last_, options);
  return again.status != TrackingStatus::lost ? again : result;
}

/// The best pose around the last one and around similar keyframes.
TrackingResult CameraTracker::search(const Measurement& measurement) {
  const CameraIntrinsics& camera = measurement.pyramid.front().camera;
  if (!view_) view_ = predict_at_last(camera);
  TrackingResult best = best_around(measurement, *view_);
  for (const Eigen::Isometry3d& place : keyframes_.most_similar(
           measurement, static_cast<std::size_t>(options_.relocalize_keyframes))) {
    TrackingResult found = best_around(measurement, predict(camera, place));
    if (found.agreement > best.agreement) best = std::move(found);
  }
  return best;
}

/// The pose around a view's at which a measurement agrees with it most.
TrackingResult CameraTracker::best_around(const Measurement& measurement, const ModelView& view) {
  return clock_->time(StageClock::track, [&] {
    return search_camera(measurement, view, view.T_world_camera, options_, sensor_);
  });
}

}  // namespace symscene
