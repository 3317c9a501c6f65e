#include "symscene/symmetry/curve_detection.hpp"

#include <algorithm>
#include <optional>

#include "core/parallel.hpp"
#include "curve_matching.hpp"
#include "distinct_candidates.hpp"
#include "symmetry/point_residuals.hpp"
#include "symmetry/score_range.hpp"

namespace symscene {
namespace {

using CurvePair = std::pair<Index, Index>;

/// The pairs, a curve with itself included, that may match.
std::vector<CurvePair> pairs_to_match(const std::vector<EdgeCurve>& curves,
                                      const CurveMatchingOptions& options) {
  const std::vector<BoundedCurve> bounded(curves.begin(), curves.end());
  std::vector<std::vector<CurvePair>> rows(curves.size());
  parallel_for_each(curves.size(), [&](std::size_t a) {
    for (std::size_t b = a; b < curves.size(); ++b) {
      if (may_match(bounded[a], bounded[b], options))
        rows[a].emplace_back(static_cast<Index>(a), static_cast<Index>(b));
    }
  });
  std::vector<CurvePair> pairs;
  for (const std::vector<CurvePair>& row : rows) pairs.insert(pairs.end(), row.begin(), row.end());
  return pairs;
}

/// The points of the cloud within `radius` of the matched parts of both curves, ascending.
PointIndices surface_beside(const PointCloud& cloud, const CellList& cells, const EdgeCurve& a,
                            const EdgeCurve& b, const CurveMatch& match, double radius) {
  PointIndices points;
  const auto append_around = [&](const EdgeCurve::Point& point) {
    for (const Index i : point.members) {
      cells.for_each_within(cloud.position(i), static_cast<float>(radius),
                            [&](Index j, float) { points.push_back(j); });
    }
  };
  for (const CurveCorrespondence& pair : match.correspondences) {
    append_around(a.points[pair.a]);
    append_around(b.points[pair.b]);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Eq. 4.12 over the surface beside both curves.
double occlusion_of(const PointCloud& cloud, const PointIndices& support,
                    const ReflectionPlane& plane, const DistanceField& field,
                    const CurveDetectionOptions& options) {
  const PlaneReflector reflector(plane);
  const ScoreRange range = occlusion_range(options);
  double sum = 0.0;
  for (const Index i : support) sum += double{range(field.at(reflector.point(cloud.position(i))))};
  return sum / static_cast<double>(support.size());
}

double tangent_agreement(const CurveMatch& match, double max_angle) {
  double sum = 0.0;
  for (const CurveCorrespondence& pair : match.correspondences)
    sum += max_angle > 0.0 ? 1.0 - pair.angle / max_angle : 1.0;
  return sum / static_cast<double>(match.correspondences.size());
}

/// What becomes of a pair of curves.
struct PairOutcome {
  bool matched = false;                                       ///< enough points match
  std::optional<ReflectionalCandidate> clear = std::nullopt;  ///< if clear of free space
};

/// Matches curves of one cloud.
class CurveMatcher {
 public:
  CurveMatcher(const PointCloud& cloud, const DistanceField& field,
               const CurveDetectionOptions& options)
      : cloud_(cloud),
        cells_(cloud.positions, static_cast<float>(options.support_radius)),
        field_(field),
        options_(options) {}

  PairOutcome match(const EdgeCurve& a, const EdgeCurve& b) const {
    const std::optional<CurveMatch> match = match_curves(a, b, options_.matching);
    if (!match) return {};
    PointIndices support = surface_beside(cloud_, cells_, a, b, *match, options_.support_radius);
    const double occlusion = occlusion_of(cloud_, support, match->plane, field_, options_);
    const PlaneQuality quality{tangent_agreement(*match, options_.matching.max_angle),
                               match->inlier_ratio, occlusion};
    if (occlusion > options_.max_occlusion_residual) return {true, std::nullopt};
    return {true, ReflectionalCandidate{match->plane, quality, std::move(support)}};
  }

 private:
  const PointCloud& cloud_;
  CellList cells_;
  const DistanceField& field_;
  const CurveDetectionOptions& options_;
};

void sort_by_inlier_ratio(std::vector<ReflectionalCandidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.quality.inlier_score, a.support.size()) >
           std::tuple(b.quality.inlier_score, b.support.size());
  });
}

EqualPlanes equal_planes(const CurveDetectionOptions& options) {
  return {options.same_angle, options.same_distance, options.max_support_distance};
}

}  // namespace

void CurveDetectionOptions::validate() const {
  check_fields(*this);
  require_option(min_occlusion < max_occlusion, "max_occlusion", "a distance above min_occlusion",
                 max_occlusion);
}

ReflectionalDetection detect_reflectional_by_curves(const PointCloud& cloud,
                                                    const std::vector<EdgeCurve>& curves,
                                                    const DistanceField& field,
                                                    const CurveDetectionOptions& options) {
  options.validate();
  if (curves.empty()) return {};
  const CurveMatcher matcher(cloud, field, options);
  const std::vector<CurvePair> pairs = pairs_to_match(curves, options.matching);
  std::vector<PairOutcome> outcomes(pairs.size());
  parallel_for_blocks(pairs.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      outcomes[k] = matcher.match(curves[pairs[k].first], curves[pairs[k].second]);
    }
  });
  std::size_t matched = 0;
  std::vector<ReflectionalCandidate> clear;
  for (PairOutcome& outcome : outcomes) {
    matched += outcome.matched ? 1 : 0;
    if (outcome.clear) clear.push_back(std::move(*outcome.clear));
  }
  ReflectionalDetection detection;
  detection.funnel = {{"curves", curves.size()},
                      {"curves: pairs", curves.size() * (curves.size() + 1) / 2},
                      {"curves: pairs that may match", pairs.size()},
                      {"curves: enough points matched", matched},
                      {"curves: clear of free space", clear.size()}};
  sort_by_inlier_ratio(clear);
  detection.candidates = distinct_candidates(std::move(clear), cloud, equal_planes(options));
  const auto most = static_cast<std::size_t>(options.max_candidates);
  detection.funnel.push_back({"curves: distinct planes", detection.candidates.size()});
  if (detection.candidates.size() > most)
    detection.candidates.erase(detection.candidates.begin() + static_cast<std::ptrdiff_t>(most),
                               detection.candidates.end());
  return detection;
}

std::vector<ReflectionalCandidate> further_candidates(
    std::vector<ReflectionalCandidate> of_curves, const std::vector<ReflectionalCandidate>& known,
    const PointCloud& cloud, const CurveDetectionOptions& options) {
  return without_known(std::move(of_curves), known, cloud, equal_planes(options));
}

}  // namespace symscene
