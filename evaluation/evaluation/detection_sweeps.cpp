#include "detection_sweeps.hpp"

#include <algorithm>

#include "core/evenly_spaced.hpp"
#include "core/parallel.hpp"
#include "setting_counts.hpp"
#include "sweep_settings.hpp"
#include "symscene/evaluation/scene_evaluation.hpp"

namespace symscene {
namespace {

/// The loosest inlier ratio of curves in table 3.1.
constexpr double least_curve_inlier = 0.1;

std::vector<RotationAxis> axes_within(const SceneDetections& detections, double max_symmetry,
                                      double max_perpendicularity) {
  std::vector<RotationAxis> axes;
  for (const RotationalCandidate& candidate : detections.axes) {
    if (candidate.quality.symmetry_residual < max_symmetry &&
        candidate.quality.perpendicularity < max_perpendicularity)
      axes.push_back(candidate.axis);
  }
  return axes;
}

std::vector<ReflectionPlane> planes_within(const std::vector<ReflectionalCandidate>& candidates,
                                           double min_symmetry, double min_inlier) {
  std::vector<ReflectionPlane> planes;
  for (const ReflectionalCandidate& candidate : candidates) {
    if (candidate.quality.symmetry_score > min_symmetry &&
        candidate.quality.inlier_score > min_inlier)
      planes.push_back(candidate.plane);
  }
  return planes;
}

Sweep axis_sweep(const SceneDetections& detections, const SceneTruth& truth,
                 const RotationalDetectionOptions& options) {
  const auto count = [&](double symmetry, double perpendicularity) {
    return count_symmetries(truth, axes_within(detections, symmetry, perpendicularity), {});
  };
  Sweep axes;
  axes.method = axis_detection_method;
  axes.parameters = {"symmetry", "perpendicularity"};
  axes.metrics = {Metric::axes, Metric::axes_near};
  axes.settings = all_settings({evenly_spaced(0.004, 0.03, 0.002), evenly_spaced(0.6, 0.7, 0.1)});
  for (const auto& setting : axes.settings) axes.counts.push_back(count(setting[0], setting[1]));
  axes.at_default = count(options.max_symmetry_residual, options.max_perpendicularity);
  return axes;
}

Sweep surface_sweep(const SceneDetections& detections, const SceneTruth& truth,
                    const ReflectionalDetectionOptions& options) {
  const auto count = [&](double symmetry, double inlier) {
    return count_symmetries(truth, {}, planes_within(detections.planes, symmetry, inlier));
  };
  Sweep planes;
  planes.method = plane_detection_method;
  planes.parameters = {"symmetry", "inlier"};
  planes.metrics = {Metric::planes, Metric::planes_near};
  planes.settings = all_settings({evenly_spaced(0.7, 0.95, 0.05), evenly_spaced(0.2, 0.8, 0.2)});
  for (const auto& setting : planes.settings)
    planes.counts.push_back(count(setting[0], setting[1]));
  planes.at_default = count(options.min_symmetry_score, options.min_inlier_score);
  return planes;
}

/// M_S decides which points of two curves match, so that each of its values is a search of its own.
Sweep curve_sweep(const SceneDetections& detections, const SceneTruth& truth,
                  const CurveDetectionOptions& options) {
  const std::vector<double> ratios = evenly_spaced(least_curve_inlier, 0.5, 0.1);
  const auto counts = [&](double max_angle, const std::vector<double>& least) {
    CurveDetectionOptions bounds = options;
    bounds.matching.max_angle = max_angle;
    bounds.matching.min_inlier_ratio = least.front();
    const std::vector<ReflectionalCandidate> found =
        detect_reflectional_by_curves(detections.cloud, detections.curves, detections.field, bounds)
            .candidates;
    std::vector<SettingCounts> of_ratios;
    // A ratio of 0.5, where every point has a match, is to be reached.
    for (const double ratio : least)
      of_ratios.push_back(count_symmetries(truth, {}, planes_within(found, -1.0, ratio - 1e-9)));
    return of_ratios;
  };
  Sweep planes;
  planes.method = curve_detection_method;
  planes.parameters = {"tangent_degrees", "inlier"};
  planes.metrics = {Metric::planes, Metric::planes_near};
  planes.settings = all_settings({evenly_spaced(1.0, 15.0, 1.0), ratios});
  for (const double angle : evenly_spaced(1.0, 15.0, 1.0)) {
    for (SettingCounts& setting : counts(radians(angle), ratios)) planes.counts.push_back(setting);
  }
  planes.at_default =
      counts(options.matching.max_angle, {options.matching.min_inlier_ratio}).front();
  return planes;
}

/// The options with the loosest bounds of table 3.1, or their own if those are looser.
PipelineOptions relaxed(PipelineOptions options) {
  RotationalDetectionOptions& axes = options.rotational_detection;
  axes.max_symmetry_residual = std::max(axes.max_symmetry_residual, 0.03);
  axes.max_perpendicularity = std::max(axes.max_perpendicularity, 0.7);
  ReflectionalDetectionOptions& planes = options.reflectional_detection;
  planes.min_symmetry_score = std::min(planes.min_symmetry_score, 0.7);
  planes.min_inlier_score = std::min(planes.min_inlier_score, 0.2);
  return options;
}

}  // namespace

std::vector<Sweep> detection_sweeps(const Scene& scene, const SceneTruth& truth,
                                    const PipelineOptions& options,
                                    const StageTimer::OnBegin& on_begin) {
  // An empty scene, such as that of a sweep on which tracking failed, has no symmetries.
  const SceneDetections detections = scene.cloud.empty()
                                         ? SceneDetections{}
                                         : detect_symmetries(scene, relaxed(options), on_begin);
  return {axis_sweep(detections, truth, options.rotational_detection),
          surface_sweep(detections, truth, options.reflectional_detection),
          curve_sweep(detections, truth, options.curve_detection)};
}

}  // namespace symscene
