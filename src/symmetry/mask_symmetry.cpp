#include "symmetry/mask_symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/model_features.hpp"
#include "symmetry/symmetry_score.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

bool follows_from(const RotationAxis& axis, const ReflectionPlane& plane,
                  const Eigen::Vector3d& here, const ObjectSymmetryBounds& bounds) {
  const SymmetryDifference apart = difference(plane, axis, here);
  return apart.angle < bounds.plane_in_axis_angle && apart.distance < bounds.plane_in_axis_distance;
}

bool is_worth_measuring(const PlaneFeatures& images, const ObjectSymmetryBounds& bounds) {
  const double judged = images.matched + images.contradicted();
  return images.matched > bounds.min_plane_matched &&
         images.contradicted() < bounds.max_plane_contradicted * judged;
}

/// By rising misfit, without those that nearly repeat a better one: a body cannot have two parallel
/// mirrors, which would make it endless.
std::vector<MeasuredPlane> distinct_planes(std::vector<MeasuredPlane> planes,
                                           const ObjectSymmetryBounds& bounds) {
  std::stable_sort(planes.begin(), planes.end(),
                   [](const MeasuredPlane& a, const MeasuredPlane& b) {
                     return a.features.misfit() < b.features.misfit();
                   });
  std::vector<MeasuredPlane> distinct;
  for (MeasuredPlane& plane : planes) {
    const bool repeats =
        std::any_of(distinct.begin(), distinct.end(), [&](const MeasuredPlane& other) {
          return line_angle(plane.plane.normal, other.plane.normal) < bounds.same_plane_angle;
        });
    if (!repeats) distinct.push_back(std::move(plane));
  }
  return distinct;
}

void compare_with_better(std::vector<MeasuredPlane>& planes) {
  for (std::size_t k = 0; k < planes.size(); ++k) {
    PlaneFeatures& features = planes[k].features;
    features.rank = static_cast<double>(k);
    features.nearest = 0.5 * std::numbers::pi;
    features.off_square = k == 0 ? -1.0 : 1.0;
    features.best_matched = planes.front().features.matched;
    for (std::size_t j = 0; j < k; ++j) {
      const double angle = line_angle(planes[k].plane.normal, planes[j].plane.normal);
      features.nearest = std::min(features.nearest, angle);
      features.off_square = std::min(features.off_square, std::cos(angle));
    }
  }
}

/// The detectors' options for points that are a whole object: what is accepted is decided later,
/// and points near a plane count too.
WholeObjectOptions for_whole_objects(WholeObjectOptions options) {
  const ObjectSymmetryBounds& bounds = options.bounds;
  RotationalDetectionOptions& axes = options.rotational_detection;
  axes.max_symmetry_residual = bounds.max_axis_misfit;
  axes.max_occlusion_residual = bounds.max_axis_occlusion;
  axes.min_coverage = bounds.min_axis_coverage;
  ReflectionalDetectionOptions& planes = options.reflectional_detection;
  planes.min_symmetry_score = 0.5;
  planes.min_inlier_score = bounds.min_plane_matched;
  planes.max_occlusion_residual = 0.15;
  for (CorrespondenceOptions* matching : {&planes.fit.matching, &planes.scoring})
    matching->min_plane_distance = bounds.min_plane_distance;
  return options;
}

/// An object as one segment, in which symmetries are sought.
class WholeObject {
 public:
  WholeObject(const ObservedScene& scene, const WholeObjectOptions& options,
              const SceneObject& object)
      : scene_(scene),
        options_(for_whole_objects(options)),
        object_(object),
        points_(select(scene.cloud, object.points)),
        segment_{evenly_spread(points_.size(), points_.size())} {
    if (scene.table) up_ = scene.table->normal;
  }

  /// The axis that the points fit best within the bounds. A body with two axes is a ball, and of
  /// that one axis says as much as many.
  std::optional<MeasuredAxis> axis() const {
    if (!options_.rotational_stream) return std::nullopt;
    std::optional<MeasuredAxis> best;
    RotationalScores best_scores;
    for (const RotationAxis& axis : proposed_axes()) {
      const RotationalScores scores =
          rotational_scores(points_, axis, scene_.field, options_.rotational_detection);
      if (!fits(scores) || (best && scores.symmetry_residual >= best_scores.symmetry_residual))
        continue;
      best = MeasuredAxis{axis, {}, 0.0};
      best_scores = scores;
    }
    if (!best) return best;
    best->features = measure_axis(points_, best->axis, best_scores, scene_.table);
    best->probability =
        axis_probability(best->features, chosen_model(options_.axis_model, axis_model()));
    return best;
  }

  /// By rising misfit, distinct, without those that follow from an axis.
  std::vector<MeasuredPlane> planes(const std::optional<RotationAxis>& axis) const {
    const ObjectSymmetryBounds& bounds = options_.bounds;
    const std::vector<ReflectionPlane> proposed = proposed_planes();
    if (proposed.empty()) return {};
    const Eigen::Vector3d here = centroid(points_.positions);
    const PlaneMeter meter(points_, scene_.field, scene_.table, bounds);
    std::vector<MeasuredPlane> measured;
    for (const ReflectionPlane& plane : proposed) {
      if (axis && follows_from(*axis, plane, here, bounds)) continue;
      const MeasuredPlane candidate{plane, meter.measure_images(plane)};
      if (is_worth_measuring(candidate.features, bounds)) measured.push_back(candidate);
    }
    measured = distinct_planes(std::move(measured), bounds);
    for (MeasuredPlane& candidate : measured) {
      PlaneFeatures& features = candidate.features;
      meter.measure_shape(candidate.plane, features);
      features.object_score = object_.score;
      features.along_axis = axis ? std::abs(axis->direction.dot(candidate.plane.normal)) : -1.0;
    }
    compare_with_better(measured);
    const TreeModel& model = chosen_model(options_.plane_model, plane_model());
    for (MeasuredPlane& candidate : measured)
      candidate.probability = plane_probability(candidate.features, model);
    return measured;
  }

 private:
  /// Those under which the object was cut out, and those that its points propose by themselves.
  std::vector<RotationAxis> proposed_axes() const {
    std::vector<RotationAxis> axes;
    for (const ScoredAxis& own : object_.rotational) axes.push_back(own.axis);
    for (const RotationalCandidate& candidate :
         detect_rotational(points_, segment_, scene_.field, up_, options_.rotational_detection)
             .candidates)
      axes.push_back(candidate.axis);
    return axes;
  }
  std::vector<ReflectionPlane> proposed_planes() const {
    std::vector<ReflectionPlane> planes;
    for (const ScoredPlane& own : object_.reflectional) planes.push_back(own.plane);
    for (const ReflectionalCandidate& candidate :
         detect_reflectional(points_, segment_, scene_.field, up_, options_.reflectional_detection)
             .candidates)
      planes.push_back(candidate.plane);
    return planes;
  }

  bool fits(const RotationalScores& scores) const {
    const ObjectSymmetryBounds& bounds = options_.bounds;
    return scores.symmetry_residual < bounds.max_axis_misfit &&
           scores.occlusion_residual < bounds.max_axis_occlusion &&
           scores.perpendicularity < options_.rotational_detection.max_perpendicularity &&
           scores.coverage > bounds.min_axis_coverage;
  }

  ObservedScene scene_;
  WholeObjectOptions options_;
  const SceneObject& object_;
  PointCloud points_;
  std::vector<PointIndices> segment_;
  std::optional<Eigen::Vector3d> up_;
};

}  // namespace

void ObjectSymmetryBounds::validate() const {
  visit_fields(*this, [](const char* name, double value, const char* unit, const char*) {
    if (*unit == '\0') {
      require_option(value >= 0.0 && value <= 1.0, name, "a number in [0, 1]", value);
    } else {
      require_option(value >= 0.0, name, "a number of at least 0", value);
    }
  });
}

std::optional<MeasuredAxis> measured_axis(const ObservedScene& scene,
                                          const WholeObjectOptions& options,
                                          const SceneObject& object) {
  return WholeObject(scene, options, object).axis();
}

MeasuredSymmetries measure_symmetries(const ObservedScene& scene, const WholeObjectOptions& options,
                                      const SceneObject& object) {
  const WholeObject whole(scene, options, object);
  MeasuredSymmetries measured;
  measured.axis = whole.axis();
  std::optional<RotationAxis> likely;
  if (measured.axis && measured.axis->probability > 0.5) likely = measured.axis->axis;
  measured.planes = whole.planes(likely);
  return measured;
}

void list_symmetries(const MeasuredSymmetries& measured, const ObjectSymmetryBounds& bounds,
                     SceneObject& object) {
  object.rotational.clear();
  if (measured.axis && measured.axis->probability > bounds.min_axis_probability)
    object.rotational.push_back({measured.axis->axis, measured.axis->features.symmetry});
  object.reflectional.clear();
  for (const MeasuredPlane& plane : measured.planes) {
    if (plane.probability > bounds.min_plane_probability)
      object.reflectional.push_back({plane.plane, plane.features.misfit()});
  }
}

}  // namespace symscene
