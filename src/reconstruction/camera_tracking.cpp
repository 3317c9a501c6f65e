#include "reconstruction/camera_tracking.hpp"

#include <cmath>
#include <optional>

#include "constrained_motion.hpp"
#include "tracking_level.hpp"

namespace symscene {
namespace {

TrackingResult lost(const Eigen::Isometry3d& guess, const char* reason) {
  TrackingResult result;
  result.T_world_camera = guess;
  result.reason = reason;
  return result;
}

/// A measured pose with the same deviation along all comparable motions.
struct PosePrior {
  Eigen::Isometry3d T_view_measured;
  Matrix6d to_comparable;
  double weight = 0.0;  ///< of it over that of all pixels: squared ratio of their deviations
  double deviation = 0.0;

  /// The twist that moves `T` to the prior.
  Vector6d twist_from(const Eigen::Isometry3d& T) const {
    return twist_of(T_view_measured * T.inverse());
  }
  void add_to(NormalEquations& equations, const Eigen::Isometry3d& T) const {
    const Matrix6d H = weight * equations.weight * to_comparable.transpose() * to_comparable;
    equations.H += H;
    equations.b += H * twist_from(T);
  }
  bool contradicts(const Eigen::Isometry3d& T) const {
    return (to_comparable * twist_from(T)).norm() > 3.0 * deviation;
  }
};

/// The errors of model and image are correlated: of an image, so many parts are independent.
constexpr double independent_parts = 100.0;

PosePrior pose_prior(const Eigen::Isometry3d& T_view_measured, const Matrix6d& to_twist,
                     double depth, const TrackingOptions& options,
                     const MeasurementOptions& sensor) {
  const double image_deviation =
      std::hypot(options.model_deviation, static_cast<double>(sensor.noise) * depth * depth);
  const double ratio = image_deviation / options.prior_deviation;
  return {T_view_measured, to_twist.inverse(), ratio * ratio / independent_parts,
          options.prior_deviation};
}

/// The pose of a measurement in a view, refined level by level.
struct Alignment {
  Eigen::Isometry3d T_view_measured;
  Matrix6d to_twist;
  double degenerate_ratio;
  std::optional<PosePrior> prior = {};
  std::vector<std::string> free_motions = {};
  PoseFit fit = {};
  const char* failure = nullptr;

  void refine(const PointToPlaneMatcher& matcher, int iterations, bool finest,
              const TrackingOptions& options);
};

void Alignment::refine(const PointToPlaneMatcher& matcher, int iterations, bool finest,
                       const TrackingOptions& options) {
  const auto too_few = [&](const NormalEquations& equations) {
    if (equations.fit.matches < options.min_matches) failure = "the model is not in view";
    return failure != nullptr;
  };
  const NormalEquations constraints = matcher.match_constraints(T_view_measured);
  if (too_few(constraints)) return;
  const ConstrainedMotions constrained(constraints.H, constraints.weight, to_twist,
                                       degenerate_ratio);
  free_motions = constrained.names_of_free();
  for (int k = 0; k < iterations; ++k) {
    NormalEquations equations = matcher.match(T_view_measured);
    if (too_few(equations)) return;
    fit = equations.fit;
    if (prior) prior->add_to(equations, T_view_measured);
    const Vector6d step = constrained.solve(equations.H, equations.b);
    if (!step.allFinite()) {
      failure = "the alignment diverged";
      return;
    }
    T_view_measured = motion(step) * T_view_measured;
    if (!finest && step.head<3>().norm() < options.convergence &&
        step.tail<3>().norm() < options.convergence) {
      return;
    }
  }
}

Alignment align(const Measurement& measurement, const ModelView& view,
                const Eigen::Isometry3d& T_world_guess, const TrackingOptions& options,
                const MeasurementOptions& sensor, bool is_prior) {
  const std::vector<SurfaceImage> models = view_pyramid(view.image, measurement);
  const int iterations[3] = {options.iterations_fine, options.iterations_middle,
                             options.iterations_coarse};
  const double depth = mean_depth(measurement.pyramid.back());
  Alignment alignment{
      view.T_world_camera.inverse() * T_world_guess, comparable_motions(depth),
      view.has_dominant_plane ? options.flattened_degenerate_ratio : options.degenerate_ratio};
  if (is_prior) {
    alignment.prior =
        pose_prior(alignment.T_view_measured, alignment.to_twist, depth, options, sensor);
  }
  for (std::size_t level = measurement.pyramid.size(); level-- > 0 && !alignment.failure;) {
    if (iterations[level] == 0) continue;
    const double distance = options.max_distance * std::pow(0.5, 2.0 - static_cast<double>(level));
    const PointToPlaneMatcher matcher(measurement.pyramid[level], models[level],
                                      tracking_matches(distance, options, sensor));
    alignment.refine(matcher, iterations[level], level == 0, options);
  }
  return alignment;
}

/// Why a pose is not accepted; null if it is.
const char* reason_to_reject(const PoseFit& fit, const Eigen::Isometry3d& T_view_measured,
                             const TrackingOptions& options) {
  if (fit.overlap() < options.min_overlap) return "too little of the image agrees with the model";
  if (fit.inlier_share() < options.min_inliers) return "the image does not fit the model";
  if (T_view_measured.translation().norm() > options.max_translation ||
      Eigen::AngleAxisd(T_view_measured.linear()).angle() > options.max_rotation) {
    return "the camera would have jumped";
  }
  return nullptr;
}

TrackingResult tracked(const Measurement& measurement, const ModelView& view,
                       const Eigen::Isometry3d& T_world_guess, const TrackingOptions& options,
                       const MeasurementOptions& sensor, bool is_prior) {
  if (!measures_enough(measurement, options)) {
    TrackingResult result = lost(T_world_guess, "too little of the image is measured");
    result.searchable = false;
    return result;
  }
  const Alignment alignment = align(measurement, view, T_world_guess, options, sensor, is_prior);
  if (alignment.failure) return lost(T_world_guess, alignment.failure);
  if (alignment.prior && alignment.prior->contradicts(alignment.T_view_measured))
    return lost(T_world_guess, "the image contradicts the given pose");
  TrackingResult result;
  result.T_world_camera = orthonormal(view.T_world_camera * alignment.T_view_measured);
  result.overlap = alignment.fit.overlap();
  result.inliers = alignment.fit.inlier_share();
  result.agreement = alignment.fit.agreement();
  result.residual = alignment.fit.residual();
  result.unconstrained = alignment.free_motions;
  if (const char* reason = reason_to_reject(alignment.fit, alignment.T_view_measured, options)) {
    result.reason = reason;
  } else {
    result.status =
        result.unconstrained.empty() ? TrackingStatus::converged : TrackingStatus::degenerate;
  }
  return result;
}

}  // namespace

const char* to_string(TrackingStatus status) {
  switch (status) {
    case TrackingStatus::converged:
      return "converged";
    case TrackingStatus::degenerate:
      return "degenerate";
    case TrackingStatus::lost:
      return "lost";
  }
  return "";
}

bool measures_enough(const Measurement& measurement, const TrackingOptions& options) {
  const auto pixels = static_cast<double>(measurement.pyramid.front().pixels.size());
  return static_cast<double>(measurement.measured) >= options.min_measured * pixels;
}

TrackingResult track_camera(const Measurement& measurement, const ModelView& view,
                            const Eigen::Isometry3d& T_world_guess, const TrackingOptions& options,
                            const MeasurementOptions& sensor) {
  return tracked(measurement, view, T_world_guess, options, sensor, false);
}

TrackingResult track_camera_with_prior(const Measurement& measurement, const ModelView& view,
                                       const Eigen::Isometry3d& T_world_prior,
                                       const TrackingOptions& options,
                                       const MeasurementOptions& sensor) {
  return tracked(measurement, view, T_world_prior, options, sensor, true);
}

}  // namespace symscene
