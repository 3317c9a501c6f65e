#include "symscene/reconstruction/reconstruction.hpp"

#include <chrono>
#include <limits>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

enum Stage : std::size_t { prepare, track, integrate, map_space, predict_view };

TrackingResult known_pose(const Eigen::Isometry3d& T_world_camera) {
  TrackingResult result;
  result.status = TrackingStatus::converged;
  result.T_world_camera = T_world_camera;
  result.overlap = result.inliers = 1.0;
  return result;
}

void require_pose(const Eigen::Isometry3d& T_world_camera) {
  const Eigen::Matrix3d R = T_world_camera.linear();
  const bool rigid = (R * R.transpose()).isIdentity(1e-4) && R.determinant() > 0.0;
  if (T_world_camera.matrix().allFinite() && rigid && T_world_camera.translation().norm() < 1e5) {
    return;
  }
  throw InputError("camera's pose", "a rotation and a place within 100 km", "another matrix");
}

}  // namespace

void ReconstructionOptions::validate() const {
  measurement.validate();
  tsdf.validate();
  tracking.validate();
  occupancy.validate();
  surface.validate();
}

Reconstruction::Reconstruction(const CameraIntrinsics& camera, const ReconstructionOptions& options)
    : camera_(camera),
      options_(options),
      volume_(options.tsdf, options.measurement),
      occupancy_(options.occupancy),
      times_{{"prepare", 0}, {"track", 0}, {"fuse", 0}, {"map space", 0}, {"predict view", 0}} {
  options_.validate();
}

template <class Body>
auto Reconstruction::timed(std::size_t stage, const Body& body) {
  struct Stop {
    double& total;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Stop() {
      total += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
  } const stop{times_[stage].seconds};
  return body();
}

FrameReport Reconstruction::add(const DepthFrame& frame,
                                const std::optional<Eigen::Isometry3d>& T_world_camera,
                                PoseUse use) {
  if (T_world_camera) require_pose(*T_world_camera);
  const Measurement measurement =
      timed(prepare, [&] { return prepare_measurement(frame, camera_, options_.measurement); });
  FrameReport report;
  if (T_world_camera && use == PoseUse::exact) {
    report.tracking = known_pose(*T_world_camera);
  } else {
    report.tracking = locate(measurement, T_world_camera, report.relocalized);
  }
  if (report.tracking.status != TrackingStatus::lost &&
      !volume_.in_reach(report.tracking.T_world_camera)) {
    report.tracking.status = TrackingStatus::lost;
    report.tracking.reason = "the camera is too far from the model's origin";
  }
  lost_ = report.tracking.status == TrackingStatus::lost;
  if (lost_) {
    motion_.setIdentity();
    return report;
  }
  const Eigen::Isometry3d& pose = report.tracking.T_world_camera;
  // A motion that nothing confirms does not go on by itself.
  const bool is_known = !volume_.empty() && !report.relocalized &&
                        report.tracking.status == TrackingStatus::converged;
  motion_ = is_known ? T_world_last_.inverse() * pose : Eigen::Isometry3d::Identity();
  if (is_known) disagreement_ += 0.25 * (1.0 - report.tracking.agreement - disagreement_);
  fuse(frame, measurement, pose);
  report.fused = true;
  return report;
}

void Reconstruction::fuse(const DepthFrame& frame, const Measurement& measurement,
                          const Eigen::Isometry3d& T_world_camera) {
  timed(integrate, [&] { volume_.integrate(measurement, T_world_camera); });
  timed(map_space, [&] { occupancy_.integrate(frame, camera_, T_world_camera); });
  keyframes_.add(measurement, T_world_camera, options_.tracking.keyframe_distance,
                 options_.tracking.keyframe_angle);
  T_world_last_ = T_world_camera;
  view_.reset();
}

/// Smoothed as measured images are: noise of the model's normals would hold the camera back.
ModelView Reconstruction::predict(const CameraIntrinsics& camera,
                                  const Eigen::Isometry3d& T_world_camera) {
  return timed(predict_view, [&] {
    ModelView view = cast_model_view(volume_, camera, T_world_camera);
    std::vector<float> depth(view.image.pixels.size());
    for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = view.image.pixels[i].depth;
    view.image = find_surface(std::move(depth), camera, options_.measurement);
    return view;
  });
}

TrackingResult Reconstruction::locate(const Measurement& measurement,
                                      const std::optional<Eigen::Isometry3d>& guess,
                                      bool& relocalized) {
  if (volume_.empty()) {
    TrackingResult first = known_pose(guess.value_or(Eigen::Isometry3d::Identity()));
    const double pixels = static_cast<double>(measurement.pyramid.front().pixels.size());
    if (static_cast<double>(measurement.measured) < options_.tracking.min_measured * pixels) {
      first.status = TrackingStatus::lost;
      first.reason = "too little of the image is measured";
    }
    return first;
  }
  TrackingResult result = follow(measurement, guess);
  const bool followed = result.status != TrackingStatus::lost;
  if (!result.searchable || (followed && !lost_ && agrees(result))) return result;
  // Much of a table looks alike from all sides: a lost camera is where it fits best, and only if it
  // fits as well there as frames did before.
  TrackingResult found = search(measurement);
  if (found.agreement < result.agreement && followed) found = result;
  if (found.status != TrackingStatus::converged || !agrees(found)) {
    if (followed) result.reason = "the image agrees with the model less than those before it";
    result.status = TrackingStatus::lost;
    return result;
  }
  relocalized = lost_;
  return found;
}

/// A lost camera has to agree as well as it used to: half of what is measured may be a bare table,
/// which agrees from everywhere.
bool Reconstruction::agrees(const TrackingResult& result) const {
  const double slack = options_.tracking.max_disagreement;
  const double bound = lost_ ? 2.0 * disagreement_ + 0.4 * slack : 3.0 * disagreement_ + slack;
  return 1.0 - result.agreement <= bound;
}

/// From where the camera must be by now if it moves on as it did; failing that, from where it was.
TrackingResult Reconstruction::follow(const Measurement& measurement,
                                      const std::optional<Eigen::Isometry3d>& guess) {
  const CameraIntrinsics& camera = measurement.pyramid.front().camera;
  TrackingOptions options = options_.tracking;
  if (lost_) {
    options.min_overlap = options.relocalize_overlap;
    options.min_inliers = options.relocalize_inliers;
  }
  if (guess) {
    const ModelView view = predict(camera, *guess);
    return timed(track, [&] {
      return track_camera(measurement, view, *guess, options, options_.measurement);
    });
  }
  if (!view_) view_ = predict(camera, T_world_last_);
  const auto from = [&](const Eigen::Isometry3d& start) {
    return timed(track, [&] {
      return track_camera(measurement, *view_, start, options, options_.measurement);
    });
  };
  const TrackingResult result = from(T_world_last_ * motion_);
  if (result.status != TrackingStatus::lost) return result;
  const TrackingResult again = from(T_world_last_);
  return again.status != TrackingStatus::lost ? again : result;
}

/// Around where it was and around keyframes that look alike.
TrackingResult Reconstruction::search(const Measurement& measurement) {
  constexpr std::size_t keyframes = 3, starts = 8;
  TrackingOptions options = options_.tracking;
  options.min_overlap = options.relocalize_overlap;
  options.min_inliers = options.relocalize_inliers;
  options.max_translation = options.max_rotation = std::numeric_limits<double>::infinity();
  TrackingResult best;
  std::vector<Eigen::Isometry3d> places = keyframes_.most_similar(measurement, keyframes);
  places.insert(places.begin(), T_world_last_);
  for (const Eigen::Isometry3d& place : places) {
    const ModelView view = predict(measurement.pyramid.front().camera, place);
    timed(track, [&] {
      for (const Eigen::Isometry3d& start :
           likely_poses(measurement, view, place, starts, options, options_.measurement)) {
        TrackingResult result =
            track_camera(measurement, view, start, options, options_.measurement);
        if (result.status != TrackingStatus::converged) continue;
        if (result.agreement > best.agreement) best = std::move(result);
      }
    });
  }
  return best;
}

}  // namespace symscene
