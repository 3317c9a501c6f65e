#include "proposals/merge.hpp"

#include <algorithm>
#include <optional>

namespace symscene {
namespace {

/// Adds a hypothesis's symmetry to `all` unless it nearly repeats one of them.
template <class Symmetry, class WithResidual>
void add_distinct(const std::optional<Symmetry>& symmetry, double residual,
                  Symmetry WithResidual::*member, const SameSymmetry& same,
                  std::vector<WithResidual>& all) {
  if (!symmetry) return;
  const bool repeats = std::any_of(all.begin(), all.end(), [&](const WithResidual& other) {
    return same(*symmetry, other.*member);
  });
  if (!repeats) all.push_back({*symmetry, residual});
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
    const double residual = rated.hypothesis.residuals.symmetry;
    const SameSymmetry same_symmetry{here, options.same_angle, options.same_distance};
    add_distinct(rated.hypothesis.axis, residual, &ObjectAxis::axis, same_symmetry, same->axes);
    add_distinct(rated.hypothesis.plane, residual, &ObjectPlane::plane, same_symmetry,
                 same->planes);
  }
  const auto by_residual = [](const auto& a, const auto& b) { return a.residual < b.residual; };
  for (MergedHypothesis& each : merged) {
    std::stable_sort(each.axes.begin(), each.axes.end(), by_residual);
    std::stable_sort(each.planes.begin(), each.planes.end(), by_residual);
  }
  return merged;
}

}  // namespace symscene
