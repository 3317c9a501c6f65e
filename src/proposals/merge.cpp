#include "proposals/merge.hpp"

#include <algorithm>

namespace symscene {
namespace {

void add_symmetries(const Hypothesis& from, const Eigen::Vector3d& here,
                    const MergeOptions& options, SceneObject& object) {
  const auto is_known = [&](const auto& symmetry, const auto& known) {
    const SymmetryDifference apart = difference(symmetry, known, here);
    return apart.angle < options.same_angle && apart.distance < options.same_distance;
  };
  for (const ScoredAxis& axis : from.rotational) {
    const bool known =
        std::any_of(object.rotational.begin(), object.rotational.end(),
                    [&](const ScoredAxis& other) { return is_known(axis.axis, other.axis); });
    if (!known) object.rotational.push_back(axis);
  }
  for (const ScoredPlane& plane : from.reflectional) {
    const bool known =
        std::any_of(object.reflectional.begin(), object.reflectional.end(),
                    [&](const ScoredPlane& other) { return is_known(plane.plane, other.plane); });
    if (!known) object.reflectional.push_back(plane);
  }
}

}  // namespace

void append_rated(const std::vector<Hypothesis>& hypotheses, const HypothesisBounds& bounds,
                  std::vector<RatedHypothesis>& rated) {
  for (const Hypothesis& hypothesis : hypotheses)
    rated.push_back({hypothesis, confidence(hypothesis.residuals, bounds)});
}

bool is_same_set(std::span<const Index> a, std::span<const Index> b, double same_object) {
  const auto [smaller, larger] = std::minmax({a.size(), b.size()});
  return static_cast<double>(smaller) > same_object * static_cast<double>(larger) &&
         intersection_over_union(a, b) > same_object;
}

std::vector<SceneObject> merge_hypotheses(std::vector<RatedHypothesis> hypotheses,
                                          const PointCloud& cloud, const MergeOptions& options) {
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const RatedHypothesis& a, const RatedHypothesis& b) {
                     return a.confidence > b.confidence;
                   });
  std::vector<SceneObject> objects;
  for (RatedHypothesis& rated : hypotheses) {
    PointIndices& points = rated.hypothesis.points;
    auto same = std::find_if(objects.begin(), objects.end(), [&](const SceneObject& object) {
      return is_same_set(object.points, points, options.same_object);
    });
    const Eigen::Vector3d here = centroid(cloud.positions, points);
    if (same == objects.end()) {
      SceneObject object;
      object.points = std::move(points);
      object.score = rated.confidence;
      object.centroid = here;
      same = objects.insert(objects.end(), std::move(object));
    }
    add_symmetries(rated.hypothesis, here, options, *same);
  }
  const auto by_residual = [](const auto& a, const auto& b) { return a.residual < b.residual; };
  for (SceneObject& object : objects) {
    std::stable_sort(object.rotational.begin(), object.rotational.end(), by_residual);
    std::stable_sort(object.reflectional.begin(), object.reflectional.end(), by_residual);
  }
  return objects;
}

}  // namespace symscene
