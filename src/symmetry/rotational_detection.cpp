#include "symscene/symmetry/rotational_detection.hpp"

#include <algorithm>
#include <utility>

#include "core/parallel.hpp"
#include "core/without_repeats.hpp"
#include "symmetry/score_range.hpp"
#include "symmetry/segment_axis.hpp"

namespace symscene {
namespace {

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
  std::vector<SegmentAxis> results(segments.size());
  parallel_for_each(segments.size(), [&](std::size_t s) {
    results[s] = segment_axis(cloud, segments[s], field, up, options);
  });

  const auto reached = [&](AxisOutcome outcome) {
    return static_cast<std::size_t>(
        std::count_if(results.begin(), results.end(),
                      [&](const SegmentAxis& r) { return r.judgement.outcome >= outcome; }));
  };
  RotationalDetection detection;
  detection.funnel = {{"rotational: segments fitted", segments.size()},
                      {"rotational: symmetric", reached(AxisOutcome::perpendicularity)},
                      {"rotational: not flat across the axis", reached(AxisOutcome::coverage)},
                      {"rotational: seen from enough sides", reached(AxisOutcome::occlusion)},
                      {"rotational: clear of free space", reached(AxisOutcome::accepted)}};
  std::vector<RotationalCandidate> accepted;
  for (SegmentAxis& result : results) {
    if (result.judgement.outcome == AxisOutcome::accepted)
      accepted.push_back(std::move(result.candidate));
  }
  detection.candidates = merge_equal_axes(std::move(accepted), cloud, options);
  detection.funnel.push_back({"rotational: distinct axes", detection.candidates.size()});
  return detection;
}

}  // namespace symscene
