#include "proposals/merge.hpp"

#include <algorithm>

namespace symscene {
namespace {

void add_symmetries(const Hypothesis& from, const Eigen::Vector3d& here,
                    const MergeOptions& options, MergedHypothesis& merged) {
  const auto is_known = [&](const auto& symmetry, const auto& known) {
    const SymmetryDifference apart = difference(symmetry, known, here);
    return apart.angle < options.same_angle && apart.distance < options.same_distance;
  };
  for (const ScoredAxis& axis : from.rotational) {
    const bool known =
        std::any_of(merged.rotational.begin(), merged.rotational.end(),
                    [&](const ScoredAxis& other) { return is_known(axis.axis, other.axis); });
    if (!known) merged.rotational.push_back(axis);
  }
  for (const ScoredPlane& plane : from.reflectional) {
    const bool known =
        std::any_of(merged.reflectional.begin(), merged.reflectional.end(),
                    [&](const ScoredPlane& other) { return is_known(plane.plane, other.plane); });
    if (!known) merged.reflectional.push_back(plane);
  }
}

}  // namespace

void append_rated(const std::vector<Hypothesis>& hypotheses, const HypothesisBounds& bounds,
                  std::vector<RatedHypothesis>& rated) {
  for (const Hypothesis& hypothesis : hypotheses)
    rated.push_back({hypothesis, confidence(hypothesis.residuals, bounds)});
}

bool cover_same_points(std::span<const Index> a, std::span<const Index> b, double same_object) {
  const auto [smaller, larger] = std::minmax({a.size(), b.size()});
  return static_cast<double>(smaller) > same_object * static_cast<double>(larger) &&
         intersection_over_union(a, b) > same_object;
}

std::vector<MergedHypothesis> merge_hypotheses(std::vector<RatedHypothesis> hypotheses,
                                               const PointCloud& cloud,
                                               const MergeOptions& options) {
  std::stable_sort(hypotheses.begin(), hypotheses.end(),
                   [](const RatedHypothesis& a, const RatedHypothesis& b) {
                     return a.confidence > b.confidence;
                   });
  std::vector<MergedHypothesis> merged;
  for (RatedHypothesis& rated : hypotheses) {
    PointIndices& points = rated.hypothesis.points;
    const Eigen::Vector3d here = centroid(cloud.positions, points);
    auto same = std::find_if(merged.begin(), merged.end(), [&](const MergedHypothesis& other) {
      return cover_same_points(other.points, points, options.same_object);
    });
    if (same == merged.end())
      same = merged.insert(merged.end(),
                           MergedHypothesis{std::move(points), {}, {}, rated.confidence});
    add_symmetries(rated.hypothesis, here, options, *same);
  }
  const auto by_residual = [](const auto& a, const auto& b) { return a.residual < b.residual; };
  for (MergedHypothesis& each : merged) {
    std::stable_sort(each.rotational.begin(), each.rotational.end(), by_residual);
    std::stable_sort(each.reflectional.begin(), each.reflectional.end(), by_residual);
  }
  return merged;
}

SceneObject object_of(MergedHypothesis merged, const PointCloud& cloud, double score) {
  SceneObject object;
  object.centroid = centroid(cloud.positions, merged.points);
  object.points = std::move(merged.points);
  object.score = score;
  object.rotational = std::move(merged.rotational);
  object.reflectional = std::move(merged.reflectional);
  return object;
}

}  // namespace symscene
