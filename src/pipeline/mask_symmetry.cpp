#include "symscene/pipeline/mask_symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "symscene/pipeline/symmetry_score.hpp"

namespace symscene {
namespace {

/// The axis that the points fit best within the bounds. A body with two axes is a ball, and of that
/// one axis says as much as many.
std::optional<MeasuredAxis> best_axis(const SceneProposals& proposals, const PointCloud& points,
                                      const PipelineOptions& options,
                                      const std::vector<RotationAxis>& proposed) {
  const ObjectSymmetryBounds& bounds = options.object_symmetry;
  std::optional<MeasuredAxis> best;
  RotationalScores best_scores;
  for (const RotationAxis& axis : proposed) {
    const RotationalScores scores =
        rotational_scores(points, axis, proposals.field, options.rotational_detection);
    const bool fits = scores.symmetry < bounds.max_axis_misfit &&
                      scores.occlusion < bounds.max_axis_occlusion &&
                      scores.perpendicularity < options.rotational_detection.max_perpendicularity &&
                      scores.coverage > bounds.min_axis_coverage;
    if (!fits || (best && scores.symmetry >= best_scores.symmetry)) continue;
    best = MeasuredAxis{axis, {}, 0.0};
    best_scores = scores;
  }
  if (best) best->measures = measure_axis(points, best->axis, best_scores, proposals.table);
  return best;
}

bool follows_from(const RotationAxis& axis, const ReflectionPlane& plane,
                  const Eigen::Vector3d& here, const ObjectSymmetryBounds& bounds) {
  const SymmetryDifference apart = difference(plane, axis, here);
  return apart.angle < bounds.plane_in_axis_angle && apart.distance < bounds.plane_in_axis_distance;
}

bool is_worth_measuring(const PlaneMeasures& images, const ObjectSymmetryBounds& bounds) {
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
                     return a.measures.misfit() < b.measures.misfit();
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
    PlaneMeasures& measures = planes[k].measures;
    measures.rank = static_cast<double>(k);
    measures.nearest = 0.5 * std::numbers::pi;
    measures.off_square = k == 0 ? -1.0 : 1.0;
    measures.best_matched = planes.front().measures.matched;
    for (std::size_t j = 0; j < k; ++j) {
      const double angle = line_angle(planes[k].plane.normal, planes[j].plane.normal);
      measures.nearest = std::min(measures.nearest, angle);
      measures.off_square = std::min(measures.off_square, std::cos(angle));
    }
  }
}

/// One segment that holds all points.
std::vector<PointIndices> all_of(const PointCloud& points) {
  return {evenly_spread(points.size(), points.size())};
}

std::optional<Eigen::Vector3d> up_of(const SceneProposals& proposals) {
  if (!proposals.table) return std::nullopt;
  return proposals.table->normal;
}

/// The detectors' options for points that are a whole object: what is accepted is decided later,
/// and points near a plane count too.
PipelineOptions for_whole_objects(PipelineOptions options) {
  const ObjectSymmetryBounds& bounds = options.object_symmetry;
  RotationalDetectionOptions& axes = options.rotational_detection;
  axes.max_symmetry_score = bounds.max_axis_misfit;
  axes.max_occlusion_score = bounds.max_axis_occlusion;
  axes.min_coverage = bounds.min_axis_coverage;
  ReflectionalDetectionOptions& planes = options.reflectional_detection;
  planes.min_symmetry_score = 0.5;
  planes.min_inlier_score = bounds.min_plane_matched;
  planes.max_occlusion_score = 0.15;
  for (CorrespondenceOptions* matching : {&planes.fit.matching, &planes.scoring})
    matching->min_plane_distance = bounds.min_plane_distance;
  return options;
}

/// The distinct planes that an object's points propose, and those under which it was cut out, by
/// rising misfit. Planes that follow from its axis are left out.
std::vector<MeasuredPlane> measured_planes(const SceneProposals& proposals,
                                           const PipelineOptions& given, const SceneObject& object,
                                           const std::optional<RotationAxis>& axis) {
  const PipelineOptions options = for_whole_objects(given);
  const ObjectSymmetryBounds& bounds = options.object_symmetry;
  const PointCloud points = select(proposals.cloud, object.points);
  std::vector<ReflectionPlane> proposed;
  for (const ScoredPlane& own : object.reflectional) proposed.push_back(own.plane);
  for (const ReflectionalCandidate& candidate :
       detect_reflectional(points, all_of(points), proposals.field, up_of(proposals),
                           options.reflectional_detection)
           .candidates)
    proposed.push_back(candidate.plane);
  if (proposed.empty()) return {};
  const Eigen::Vector3d here = centroid(points.positions);
  const PlaneMeter meter(points, proposals.field, proposals.table, bounds);
  std::vector<MeasuredPlane> measured;
  for (const ReflectionPlane& plane : proposed) {
    if (axis && follows_from(*axis, plane, here, bounds)) continue;
    const MeasuredPlane candidate{plane, meter.measure_images(plane)};
    if (is_worth_measuring(candidate.measures, bounds)) measured.push_back(candidate);
  }
  measured = distinct_planes(std::move(measured), bounds);
  for (MeasuredPlane& candidate : measured) {
    PlaneMeasures& measures = candidate.measures;
    meter.measure_shape(candidate.plane, measures);
    measures.object_score = object.score;
    measures.along_axis = axis ? std::abs(axis->direction.dot(candidate.plane.normal)) : -1.0;
  }
  compare_with_better(measured);
  for (MeasuredPlane& candidate : measured)
    candidate.probability = plane_probability(candidate.measures);
  return measured;
}

}  // namespace

std::optional<MeasuredAxis> measured_axis(const SceneProposals& proposals,
                                          const PipelineOptions& given, const SceneObject& object) {
  if (!given.rotational_stream) return std::nullopt;
  const PipelineOptions options = for_whole_objects(given);
  const PointCloud points = select(proposals.cloud, object.points);
  std::vector<RotationAxis> proposed;
  for (const ScoredAxis& own : object.rotational) proposed.push_back(own.axis);
  for (const RotationalCandidate& candidate :
       detect_rotational(points, all_of(points), proposals.field, up_of(proposals),
                         options.rotational_detection)
           .candidates)
    proposed.push_back(candidate.axis);
  std::optional<MeasuredAxis> best = best_axis(proposals, points, options, proposed);
  if (best) best->probability = axis_probability(best->measures);
  return best;
}

MeasuredSymmetries measure_symmetries(const SceneProposals& proposals,
                                      const PipelineOptions& options, const SceneObject& object) {
  MeasuredSymmetries measured;
  measured.axis = measured_axis(proposals, options, object);
  std::optional<RotationAxis> likely;
  if (measured.axis && measured.axis->probability > 0.5) likely = measured.axis->axis;
  measured.planes = measured_planes(proposals, options, object, likely);
  return measured;
}

void list_symmetries(const MeasuredSymmetries& measured, const ObjectSymmetryBounds& bounds,
                     SceneObject& object) {
  object.rotational.clear();
  if (measured.axis && measured.axis->probability > bounds.min_axis_probability)
    object.rotational.push_back({measured.axis->axis, measured.axis->measures.symmetry});
  object.reflectional.clear();
  for (const MeasuredPlane& plane : measured.planes) {
    if (plane.probability > bounds.min_plane_probability)
      object.reflectional.push_back({plane.plane, plane.measures.misfit()});
  }
}

}  // namespace symscene
