#include "symscene/symmetry/rotational_detection.hpp"

#include <algorithm>
#include <utility>

#include "core/parallel.hpp"
#include "core/without_repeats.hpp"
#include "symmetry/axis_fit.hpp"
#include "symmetry/axis_quality.hpp"
#include "symmetry/score_range.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

/// The bound that a candidate fails, in the order of judgement.
enum class AxisOutcome { symmetry, perpendicularity, coverage, occlusion, accepted };

AxisOutcome judge_axis(const AxisQuality& quality, const RotationalDetectionOptions& options) {
  if (quality.symmetry_residual >= options.max_symmetry_residual) return AxisOutcome::symmetry;
  if (quality.perpendicularity >= options.max_perpendicularity)
    return AxisOutcome::perpendicularity;
  if (quality.coverage <= options.min_coverage) return AxisOutcome::coverage;
  if (quality.occlusion_residual >= options.max_occlusion_residual) return AxisOutcome::occlusion;
  return AxisOutcome::accepted;
}

/// The points of a segment that are not on its rim, where normals are least accurate: those whose
/// neighbours that belong to the segment lie all around them.
PointIndices interior_points(const PointCloud& cloud, const PointIndices& segment,
                             const RotationalDetectionOptions& options) {
  const auto radius = static_cast<float>(options.rim_radius);
  const auto rim_offset = static_cast<float>(options.rim_offset);
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

/// The candidate of a segment that passes most bounds.
struct AxisOfSegment {
  AxisOutcome outcome = AxisOutcome::symmetry;
  RotationalCandidate candidate;
};

AxisOfSegment detect_in_segment(const PointCloud& cloud, const PointIndices& segment,
                                const DistanceField& field,
                                const std::vector<Eigen::Vector3d>& directions,
                                const RotationalDetectionOptions& options) {
  AxisOfSegment best;
  const PointCloud interior = select(cloud, interior_points(cloud, segment, options));
  for (const RotationAxis& initial : initial_axes(interior, directions, options.fit)) {
    const AxisFit fit = fit_axis(interior, initial, options.fit);
    if (!is_usable(fit.status)) continue;
    const AxisQuality quality = axis_quality(interior, fit.axis, field, options);
    const AxisOutcome outcome = judge_axis(quality, options);
    const bool better = outcome > best.outcome ||
                        (outcome == AxisOutcome::accepted &&
                         quality.occlusion_residual < best.candidate.quality.occlusion_residual);
    if (better) best = {outcome, {fit.axis, quality, {}}};
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
  return without_repeats(std::move(candidates), [&](const auto& candidate, const auto& other) {
    const SameSymmetry same{centroid(cloud.positions, candidate.support), options.same_angle,
                            options.same_distance};
    return same(candidate.axis, other.axis);
  });
}

}  // namespace

void RotationalDetectionOptions::validate() const {
  check_fields(*this);
  require_score_ranges(*this);
}

RotationalDetection detect_rotational(const PointCloud& cloud,
                                      const std::vector<PointIndices>& segments,
                                      const DistanceField& field,
                                      const std::optional<Eigen::Vector3d>& up,
                                      const RotationalDetectionOptions& options) {
  options.validate();
  std::vector<Eigen::Vector3d> directions;
  if (up) directions.push_back(*up);
  std::vector<AxisOfSegment> results(segments.size());
  parallel_for_each(segments.size(), [&](std::size_t s) {
    results[s] = detect_in_segment(cloud, segments[s], field, directions, options);
  });

  const auto reached = [&](AxisOutcome outcome) {
    return static_cast<std::size_t>(
        std::count_if(results.begin(), results.end(),
                      [&](const AxisOfSegment& r) { return r.outcome >= outcome; }));
  };
  RotationalDetection detection;
  detection.funnel = {{"rotational: segments fitted", segments.size()},
                      {"rotational: symmetric", reached(AxisOutcome::perpendicularity)},
                      {"rotational: not flat across the axis", reached(AxisOutcome::coverage)},
                      {"rotational: seen from enough sides", reached(AxisOutcome::occlusion)},
                      {"rotational: clear of free space", reached(AxisOutcome::accepted)}};
  std::vector<RotationalCandidate> accepted;
  for (AxisOfSegment& result : results) {
    if (result.outcome == AxisOutcome::accepted) accepted.push_back(std::move(result.candidate));
  }
  detection.candidates = merge_equal_axes(std::move(accepted), cloud, options);
  detection.funnel.push_back({"rotational: distinct axes", detection.candidates.size()});
  return detection;
}

}  // namespace symscene
