#include "symscene/symmetry/rotational_detection.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr float rim_radius = 0.01F;

/// How far a candidate got through the bounds.
enum class Outcome { symmetry, perpendicularity, coverage, occlusion, accepted };

Outcome judge(const RotationalScores& scores, const RotationalDetectionOptions& options) {
  if (scores.symmetry_residual >= options.max_symmetry_residual) return Outcome::symmetry;
  if (scores.perpendicularity >= options.max_perpendicularity) return Outcome::perpendicularity;
  if (scores.coverage <= options.min_coverage) return Outcome::coverage;
  if (scores.occlusion_residual >= options.max_occlusion_residual) return Outcome::occlusion;
  return Outcome::accepted;
}

/// What became of a segment.
struct SegmentResult {
  Outcome outcome = Outcome::symmetry;
  RotationalCandidate candidate;
};

SegmentResult detect_in_segment(const PointCloud& cloud, const PointIndices& segment,
                                const DistanceField& field,
                                const std::vector<Eigen::Vector3d>& directions,
                                const RotationalDetectionOptions& options) {
  SegmentResult best;
  const PointCloud interior = select(cloud, interior_points(cloud, segment, rim_radius));
  for (const RotationAxis& initial : initial_axes(interior, directions, options.fit)) {
    const AxisFit fit = fit_axis(interior, initial, options.fit);
    if (!is_usable(fit.status)) continue;
    const RotationalScores scores = rotational_scores(interior, fit.axis, field, options);
    const Outcome outcome = judge(scores, options);
    const bool better = outcome > best.outcome ||
                        (outcome == Outcome::accepted &&
                         scores.occlusion_residual < best.candidate.scores.occlusion_residual);
    if (better) best = {outcome, {fit.axis, scores, {}}};
  }
  best.candidate.support = segment;
  return best;
}

std::vector<RotationalCandidate> merge_equal_axes(std::vector<RotationalCandidate> candidates,
                                                  const PointCloud& cloud,
                                                  const RotationalDetectionOptions& options) {
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return a.support.size() > b.support.size();
  });
  std::vector<RotationalCandidate> distinct;
  for (RotationalCandidate& candidate : candidates) {
    const Eigen::Vector3d here = centroid(cloud.positions, candidate.support);
    const bool repeats =
        std::any_of(distinct.begin(), distinct.end(), [&](const RotationalCandidate& other) {
          const SymmetryDifference apart = difference(candidate.axis, other.axis, here);
          return apart.angle < options.same_angle && apart.distance < options.same_distance;
        });
    if (!repeats) distinct.push_back(std::move(candidate));
  }
  return distinct;
}

}  // namespace

void RotationalDetectionOptions::validate() const {
  fit.validate();
  require_score_ranges(*this);
  require_option(max_angle <= std::numbers::pi / 2, "max_angle", "an angle of at most pi/2 rad",
                 max_angle);
  require_option(max_symmetry_residual >= 0.0 && max_symmetry_residual <= 1.0,
                 "max_symmetry_residual", "a score in [0, 1]", max_symmetry_residual);
  require_option(max_perpendicularity >= 0.0 && max_perpendicularity <= 1.0, "max_perpendicularity",
                 "a score in [0, 1]", max_perpendicularity);
  require_option(max_occlusion_residual >= 0.0 && max_occlusion_residual <= 1.0,
                 "max_occlusion_residual", "a score in [0, 1]", max_occlusion_residual);
  require_option(min_coverage >= 0.0 && min_coverage <= 1.0, "min_coverage",
                 "a share of a turn in [0, 1]", min_coverage);
  require_option(same_angle >= 0.0, "same_angle", "an angle of at least 0 rad", same_angle);
  require_option(same_distance >= 0.0, "same_distance", "a distance of at least 0 m",
                 same_distance);
}

double angular_coverage(const Points& points, const RotationAxis& axis) {
  constexpr int bins = 360;
  const Eigen::Matrix<double, 3, 2> across = orthonormal_complement(axis.direction);
  const Eigen::Vector3d u = across.col(0);
  const Eigen::Vector3d v = across.col(1);
  std::bitset<bins> seen;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::Vector3d q = points.row(i).transpose().cast<double>() - axis.point;
    const double turn = std::atan2(v.dot(q), u.dot(q)) / (2.0 * std::numbers::pi) + 0.5;
    seen.set(std::min(static_cast<std::size_t>(turn * bins), std::size_t{bins - 1}));
  }
  if (seen.none()) return 0.0;
  int gap = 0;
  int largest_gap = 0;
  for (std::size_t bin = 0; bin < 2 * bins; ++bin) {
    gap = seen[bin % bins] ? 0 : gap + 1;
    largest_gap = std::max(largest_gap, gap);
  }
  return 1.0 - static_cast<double>(largest_gap) / bins;
}

PointIndices interior_points(const PointCloud& cloud, const PointIndices& segment, float radius) {
  // A point with neighbours over a sector of 225° or less (a gap of 135°) has their mean this far
  // off or farther.
  constexpr float rim_offset = 0.31F;
  const PointCloud members = select(cloud, segment);
  const CellList cells(members.positions, radius);
  PointIndices interior;
  for (Index k = 0; k < members.size(); ++k) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    float count = 0.0F;
    const Eigen::Vector3f here = members.position(k);
    cells.for_each_within(here, radius, [&](Index j, float) {
      if (j == k) return;
      sum += members.position(j) - here;
      count += 1.0F;
    });
    if (sum.norm() < rim_offset * radius * count) interior.push_back(segment[k]);
  }
  return interior;
}

RotationalScores rotational_scores(const PointCloud& cloud, const RotationAxis& axis,
                                   const DistanceField& field,
                                   const RotationalDetectionOptions& options) {
  if (cloud.empty()) return {1.0, 1.0, 0.0, 1.0};
  const AxisScorer scorer(axis);
  const ScoreRange angle_range = options.angle_range();
  const ScoreRange occlusion_range = options.occlusion_range();
  RotationalScores scores;
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f p = cloud.position(i);
    const Eigen::Vector3f n = cloud.normal(i);
    scores.symmetry_residual += double{angle_range(scorer.plane_angle(p, n))};
    scores.perpendicularity += 1.0 - double{scorer.axis_angle(n)} / (std::numbers::pi / 2);
    scores.occlusion_residual += double{occlusion_range(scorer.free_distance(p, field))};
  }
  const auto count = static_cast<double>(cloud.size());
  scores.symmetry_residual /= count;
  scores.perpendicularity /= count;
  scores.occlusion_residual /= count;
  scores.coverage = angular_coverage(cloud.positions, axis);
  return scores;
}

RotationalDetection detect_rotational(const PointCloud& cloud,
                                      const std::vector<PointIndices>& segments,
                                      const DistanceField& field,
                                      const std::optional<Eigen::Vector3d>& up,
                                      const RotationalDetectionOptions& options) {
  options.validate();
  std::vector<Eigen::Vector3d> directions;
  if (up) directions.push_back(*up);
  std::vector<SegmentResult> results(segments.size());
  parallel_for_each(segments.size(), [&](std::size_t s) {
    results[s] = detect_in_segment(cloud, segments[s], field, directions, options);
  });

  const auto reached = [&](Outcome outcome) {
    return static_cast<std::size_t>(
        std::count_if(results.begin(), results.end(),
                      [&](const SegmentResult& r) { return r.outcome >= outcome; }));
  };
  RotationalDetection detection;
  detection.funnel = {{"rotational: segments fitted", segments.size()},
                      {"rotational: symmetric", reached(Outcome::perpendicularity)},
                      {"rotational: not flat across the axis", reached(Outcome::coverage)},
                      {"rotational: seen from enough sides", reached(Outcome::occlusion)},
                      {"rotational: clear of free space", reached(Outcome::accepted)}};
  std::vector<RotationalCandidate> accepted;
  for (SegmentResult& result : results) {
    if (result.outcome == Outcome::accepted) accepted.push_back(std::move(result.candidate));
  }
  detection.candidates = merge_equal_axes(std::move(accepted), cloud, options);
  detection.funnel.push_back({"rotational: distinct axes", detection.candidates.size()});
  return detection;
}

}  // namespace symscene
