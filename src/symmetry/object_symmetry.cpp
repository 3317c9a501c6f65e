#include "symmetry/object_symmetry.hpp"

#include <algorithm>
#include <utility>

#include "core/model_features.hpp"
#include "core/without_repeats.hpp"
#include "symmetry/axis_quality.hpp"
#include "symmetry/symmetry_score.hpp"

namespace symscene {
namespace {

bool is_implied(const ReflectionPlane& plane, const RotationAxis& axis, const Eigen::Vector3d& here,
                const ObjectSymmetryOptions& options) {
  const SymmetryDifference apart = difference(plane, axis, here);
  return apart.angle < options.plane_in_axis_angle &&
         apart.distance < options.plane_in_axis_distance;
}

bool is_plausible(const ImageFeatures& images, const ObjectSymmetryOptions& options) {
  const double judged = images.matched + images.contradicted();
  return images.matched > options.min_plane_matched &&
         images.contradicted() < options.max_plane_contradicted * judged;
}

/// By rising residual, without planes that nearly repeat one of lower residual.
std::vector<MatchedPlane> distinct_planes(std::vector<MatchedPlane> planes, double same_angle) {
  std::stable_sort(planes.begin(), planes.end(), [](const MatchedPlane& a, const MatchedPlane& b) {
    return a.images.plane_residual() < b.images.plane_residual();
  });
  return without_repeats(std::move(planes), [&](const MatchedPlane& a, const MatchedPlane& b) {
    return line_angle(a.plane.normal, b.plane.normal) < same_angle;
  });
}

/// The options with the detectors' bounds replaced by those of candidates: which candidates are
/// symmetries is decided later, by their features.
SymmetrySearchOptions with_candidate_bounds(SymmetrySearchOptions options) {
  const ObjectSymmetryOptions& bounds = options.object_symmetry;
  RotationalDetectionOptions& axes = options.rotational_detection;
  axes.max_symmetry_residual = bounds.max_axis_residual;
  axes.max_occlusion_residual = bounds.max_axis_occlusion;
  axes.min_coverage = bounds.min_axis_coverage;
  ReflectionalDetectionOptions& planes = options.reflectional_detection;
  planes.min_symmetry_score = bounds.min_plane_symmetry;
  planes.min_inlier_score = bounds.min_plane_inlier;
  planes.max_occlusion_residual = bounds.max_plane_occlusion;
  return options;
}

/// Searches the symmetries of an object, its points being one segment.
class SymmetrySearch {
 public:
  SymmetrySearch(const ObservedScene& scene, const SearchedObject& object,
                 const SymmetrySearchOptions& options)
      : scene_(scene),
        object_(object),
        options_(with_candidate_bounds(options)),
        points_(select(scene.cloud, object.points)),
        segment_{evenly_spread(points_.size(), points_.size())} {
    if (scene.table) up_ = scene.table->normal;
  }

  /// At most one: a bounded body with two axes is a sphere.
  std::optional<AxisCandidate> axis() const {
    if (!options_.rotational_stream) return std::nullopt;
    std::optional<RotationAxis> best;
    AxisQuality best_quality;
    for (const RotationAxis& axis : proposed_axes()) {
      const AxisQuality quality =
          axis_quality(points_, axis, scene_.field, options_.rotational_detection);
      if (!is_within_bounds(quality)) continue;
      if (best && quality.symmetry_residual >= best_quality.symmetry_residual) continue;
      best = axis;
      best_quality = quality;
    }
    if (!best) return std::nullopt;
    const AxisFeatures features = axis_features(points_, *best, best_quality, scene_.table,
                                                options_.object_symmetry.axis_features);
    return AxisCandidate{
        *best, features,
        axis_probability(features, chosen_model(options_.axis_model, axis_model()))};
  }

  /// By rising residual, distinct, without those that `axis` implies.
  std::vector<PlaneCandidate> planes(const std::optional<RotationAxis>& axis) const {
    const std::vector<ReflectionPlane> proposed = proposed_planes();
    if (proposed.empty()) return {};
    const PlaneFeatureExtractor extractor(points_, scene_.field, scene_.table,
                                          options_.object_symmetry.plane_features);
    const std::vector<MatchedPlane> matched = plausible_planes(proposed, axis, extractor);
    const TreeModel& model = chosen_model(options_.plane_model, plane_model());
    std::vector<PlaneCandidate> candidates;
    for (std::size_t k = 0; k < matched.size(); ++k) {
      const PlaneFeatures features =
          extractor.features(matched[k], {object_.score, axis, std::span(matched).first(k)});
      candidates.push_back({matched[k].plane, features, plane_probability(features, model)});
    }
    return candidates;
  }

 private:
  /// Those under which the object was segmented, then those that its points propose.
  std::vector<RotationAxis> proposed_axes() const {
    std::vector<RotationAxis> axes = object_.axes;
    const RotationalDetection detection =
        detect_rotational(points_, segment_, scene_.field, up_, options_.rotational_detection);
    for (const RotationalCandidate& candidate : detection.candidates)
      axes.push_back(candidate.axis);
    return axes;
  }
  std::vector<ReflectionPlane> proposed_planes() const {
    std::vector<ReflectionPlane> planes = object_.planes;
    const ReflectionalDetection detection =
        detect_reflectional(points_, segment_, scene_.field, up_, options_.reflectional_detection);
    for (const ReflectionalCandidate& candidate : detection.candidates)
      planes.push_back(candidate.plane);
    if (scene_.table) planes.push_back(level_plane(*scene_.table));
    return planes;
  }

  /// Half way between the object's top and the table, or its lowest points if it does not rest on
  /// the table. No detector finds it if too few of the sides are seen to align, as the face that is
  /// the image of the top is hidden.
  ReflectionPlane level_plane(const Plane& table) const {
    std::vector<double> heights;
    for (Index i = 0; i < points_.size(); ++i)
      heights.push_back(table.signed_distance(points_.position(i).cast<double>()));
    std::sort(heights.begin(), heights.end());
    const double top = heights[heights.size() * 49 / 50], low = heights[heights.size() / 50];
    const double bottom = low < options_.object_symmetry.max_resting_gap ? 0.0 : low;
    const Eigen::Vector3d here = centroid(points_.positions);
    const double shift = 0.5 * (top + bottom) - table.signed_distance(here);
    return {here + shift * table.normal, table.normal};
  }

  std::vector<MatchedPlane> plausible_planes(const std::vector<ReflectionPlane>& proposed,
                                             const std::optional<RotationAxis>& axis,
                                             const PlaneFeatureExtractor& extractor) const {
    const ObjectSymmetryOptions& bounds = options_.object_symmetry;
    const Eigen::Vector3d here = centroid(points_.positions);
    std::vector<MatchedPlane> plausible;
    for (const ReflectionPlane& plane : proposed) {
      if (axis && is_implied(plane, *axis, here, bounds)) continue;
      const MatchedPlane matched = extractor.match(plane);
      if (is_plausible(matched.images, bounds)) plausible.push_back(matched);
    }
    return distinct_planes(std::move(plausible), bounds.same_plane_angle);
  }

  bool is_within_bounds(const AxisQuality& quality) const {
    const ObjectSymmetryOptions& bounds = options_.object_symmetry;
    return quality.symmetry_residual < bounds.max_axis_residual &&
           quality.occlusion_residual < bounds.max_axis_occlusion &&
           quality.perpendicularity < options_.rotational_detection.max_perpendicularity &&
           quality.coverage > bounds.min_axis_coverage;
  }

  ObservedScene scene_;
  const SearchedObject& object_;
  SymmetrySearchOptions options_;
  PointCloud points_;
  std::vector<PointIndices> segment_;
  std::optional<Eigen::Vector3d> up_;
};

}  // namespace

std::optional<AxisCandidate> axis_candidate(const ObservedScene& scene,
                                            const SearchedObject& object,
                                            const SymmetrySearchOptions& options) {
  return SymmetrySearch(scene, object, options).axis();
}

SymmetryCandidates symmetry_candidates(const ObservedScene& scene, const SearchedObject& object,
                                       const SymmetrySearchOptions& options) {
  const SymmetrySearch search(scene, object, options);
  SymmetryCandidates candidates;
  candidates.axis = search.axis();
  std::optional<RotationAxis> probable;
  if (candidates.axis &&
      candidates.axis->probability > options.object_symmetry.min_implying_probability)
    probable = candidates.axis->axis;
  candidates.planes = search.planes(probable);
  return candidates;
}

ListedSymmetries list_symmetries(const SymmetryCandidates& candidates,
                                 const ObjectSymmetryOptions& options) {
  ListedSymmetries listed;
  const std::optional<AxisCandidate>& axis = candidates.axis;
  if (axis && axis->probability > options.min_axis_probability)
    listed.rotational.push_back({axis->axis, axis->features.symmetry_residual});
  for (const PlaneCandidate& plane : candidates.planes) {
    if (plane.probability > options.min_plane_probability)
      listed.reflectional.push_back({plane.plane, plane.features.images.plane_residual()});
  }
  return listed;
}

ListedSymmetries with_measured_residuals(ListedSymmetries listed, const PointCloud& points,
                                         const DistanceField& field,
                                         const SymmetrySearchOptions& options) {
  for (ObjectAxis& axis : listed.rotational)
    axis.residual =
        axis_quality(points, axis.axis, field, options.rotational_detection).symmetry_residual;
  const PlaneFeatureExtractor extractor(points, field, std::nullopt,
                                        options.object_symmetry.plane_features);
  for (ObjectPlane& plane : listed.reflectional)
    plane.residual = extractor.match(plane.plane).images.plane_residual();
  const auto by_residual = [](const auto& a, const auto& b) { return a.residual < b.residual; };
  std::stable_sort(listed.rotational.begin(), listed.rotational.end(), by_residual);
  std::stable_sort(listed.reflectional.begin(), listed.reflectional.end(), by_residual);
  return listed;
}

}  // namespace symscene
