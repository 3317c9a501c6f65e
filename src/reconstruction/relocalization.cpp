#include "reconstruction/relocalization.hpp"

#include <algorithm>
#include <limits>

#include "constrained_motion.hpp"
#include "reconstruction/camera_tracking.hpp"
#include "tracking_level.hpp"

namespace symscene {
namespace {

/// The points of a cubic grid around the origin, `steps` to each side.
std::vector<Eigen::Vector3d> search_grid(int steps, double step) {
  std::vector<Eigen::Vector3d> grid;
  for (int a = -steps; a <= steps; ++a) {
    for (int b = -steps; b <= steps; ++b) {
      for (int c = -steps; c <= steps; ++c) grid.emplace_back(step * Eigen::Vector3d(a, b, c));
    }
  }
  return grid;
}

}  // namespace

std::vector<Eigen::Isometry3d> likely_poses(const Measurement& measurement, const ModelView& view,
                                            const Eigen::Isometry3d& T_world_about,
                                            const TrackingOptions& options,
                                            const MeasurementOptions& sensor) {
  const SurfaceImage& measured = measurement.pyramid.back();
  const SurfaceImage model = view_pyramid(view.image, measurement).back();
  const PointToPlaneMatcher matcher(measured, model,
                                    tracking_matches(options.relocalize_distance, options, sensor));
  const Eigen::Isometry3d T_view_about = view.T_world_camera.inverse() * T_world_about;
  const NormalEquations about = matcher.match_constraints(T_view_about);
  if (about.fit.matches < options.min_matches) return {};
  const ConstrainedMotions constrained(
      about.H, about.weight, comparable_motions(mean_depth(measured)), options.degenerate_ratio);
  std::vector<std::pair<double, Eigen::Isometry3d>> tried;
  for (const Eigen::Vector3d& at : search_grid(options.relocalize_steps, options.relocalize_step)) {
    const Vector6d offset = constrained.motions.leftCols<3>() * at;
    const Eigen::Isometry3d T = motion(constrained.to_twist * offset) * T_view_about;
    tried.emplace_back(matcher.match(T).fit.inliers, view.T_world_camera * T);
  }
  std::stable_sort(tried.begin(), tried.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Eigen::Isometry3d> poses{T_world_about};
  const auto starts = static_cast<std::size_t>(options.relocalize_starts);
  for (std::size_t k = 0; k < std::min(starts - 1, tried.size()); ++k) {
    poses.push_back(orthonormal(tried[k].second));
  }
  return poses;
}

TrackingOptions when_lost(TrackingOptions options) {
  options.min_overlap = options.relocalize_overlap;
  options.min_inliers = options.relocalize_inliers;
  return options;
}

TrackingResult search_camera(const Measurement& measurement, const ModelView& view,
                             const Eigen::Isometry3d& T_world_about, const TrackingOptions& options,
                             const MeasurementOptions& sensor) {
  TrackingOptions bounds = when_lost(options);
  bounds.max_translation = bounds.max_rotation = std::numeric_limits<double>::infinity();
  TrackingResult best;
  for (const Eigen::Isometry3d& start :
       likely_poses(measurement, view, T_world_about, bounds, sensor)) {
    TrackingResult result = track_camera(measurement, view, start, bounds, sensor);
    if (result.status != TrackingStatus::converged) continue;
    if (result.agreement > best.agreement) best = std::move(result);
  }
  return best;
}

}  // namespace symscene
