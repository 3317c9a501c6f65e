#include "pipeline/mask_symmetry.hpp"

#include <algorithm>
#include <cmath>

namespace symscene {
namespace {

constexpr float cell_size = 0.01F;

template <class Scored, class Symmetry>
bool is_known(const std::vector<Scored>& known, Symmetry Scored::*member, const Symmetry& symmetry,
              const Eigen::Vector3d& here, const MergeOptions& same) {
  return std::any_of(known.begin(), known.end(), [&](const Scored& other) {
    const SymmetryDifference apart = difference(symmetry, other.*member, here);
    return apart.angle < same.same_angle && apart.distance < same.same_distance;
  });
}

/// Whether a plane holds an axis, where the object is.
bool follows_from(const ReflectionPlane& plane, const RotationAxis& axis,
                  const Eigen::Vector3d& here, const ObjectSymmetryBounds& bounds) {
  const double tilt = 0.5 * std::numbers::pi - line_angle(plane.normal, axis.direction);
  return tilt < bounds.plane_in_axis_angle &&
         std::abs(plane.signed_distance(axis.project(here))) < bounds.plane_in_axis_distance;
}

std::vector<ScoredAxis> axes_of(const SceneProposals& proposals, const PointCloud& points,
                                const PipelineOptions& options, const SceneObject& object,
                                const std::vector<RotationAxis>& proposed) {
  const ObjectSymmetryBounds& bounds = options.object_symmetry;
  std::vector<ScoredAxis> fits;
  for (const RotationAxis& axis : proposed) {
    const RotationalScores scores =
        rotational_scores(points, axis, proposals.field, options.rotational_detection);
    if (scores.symmetry < bounds.max_axis_misfit && scores.occlusion < bounds.max_axis_occlusion &&
        scores.perpendicularity < options.rotational_detection.max_perpendicularity &&
        scores.coverage > bounds.min_axis_coverage)
      fits.push_back({axis, scores.symmetry});
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const ScoredAxis& a, const ScoredAxis& b) { return a.score < b.score; });
  std::vector<ScoredAxis> distinct;
  for (const ScoredAxis& fit : fits) {
    if (!is_known(distinct, &ScoredAxis::axis, fit.axis, object.centroid, options.merge))
      distinct.push_back(fit);
  }
  return distinct;
}

std::vector<ScoredPlane> planes_of(const SceneProposals& proposals, const PointCloud& points,
                                   const PipelineOptions& options, const SceneObject& object,
                                   const std::vector<ReflectionPlane>& proposed) {
  const ObjectSymmetryBounds& bounds = options.object_symmetry;
  const ReflectionalDetectionOptions& detection = options.reflectional_detection;
  const CellList cells(points.positions, cell_size);
  const PointIndices sample =
      evenly_spread(points.size(), static_cast<Index>(detection.max_points));
  std::vector<ScoredPlane> fits;
  for (const ReflectionPlane& plane : proposed) {
    const ReflectionalScores scores =
        reflectional_scores(points, cells, sample, plane, proposals.field, detection);
    const bool implied =
        std::any_of(object.rotational.begin(), object.rotational.end(), [&](const ScoredAxis& own) {
          return follows_from(plane, own.axis, object.centroid, bounds);
        });
    if (!implied && scores.symmetry > bounds.min_plane_symmetry &&
        scores.inlier > bounds.min_plane_inlier && scores.occlusion < bounds.max_plane_occlusion)
      fits.push_back({plane, 1.0 - scores.inlier});
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const ScoredPlane& a, const ScoredPlane& b) { return a.score < b.score; });
  std::vector<ScoredPlane> distinct;
  for (const ScoredPlane& fit : fits) {
    if (!is_known(distinct, &ScoredPlane::plane, fit.plane, object.centroid, options.merge))
      distinct.push_back(fit);
  }
  return distinct;
}

}  // namespace

void find_symmetries(const SceneProposals& proposals, const PipelineOptions& options,
                     SceneObject& object) {
  const PointCloud points = select(proposals.cloud, object.points);
  const std::vector<PointIndices> whole{evenly_spread(points.size(), points.size())};
  std::optional<Eigen::Vector3d> up;
  if (proposals.table) up = proposals.table->normal;
  std::vector<RotationAxis> axes;
  if (options.rotational_stream) {
    for (const ScoredAxis& own : object.rotational) axes.push_back(own.axis);
    for (const RotationalCandidate& candidate :
         detect_rotational(points, whole, proposals.field, up, options.rotational_detection)
             .candidates)
      axes.push_back(candidate.axis);
  }
  object.rotational = axes_of(proposals, points, options, object, axes);
  std::vector<ReflectionPlane> planes;
  for (const ScoredPlane& own : object.reflectional) planes.push_back(own.plane);
  for (const ReflectionalCandidate& candidate :
       detect_reflectional(points, whole, proposals.field, up, options.reflectional_detection)
           .candidates)
    planes.push_back(candidate.plane);
  object.reflectional = planes_of(proposals, points, options, object, planes);
}

}  // namespace symscene
