#include "symscene/symmetry/reflectional_detection.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "core/parallel.hpp"
#include "core/without_repeats.hpp"
#include "distinct_candidates.hpp"
#include "plane_placement.hpp"
#include "symmetry/plane_quality.hpp"
#include "symmetry/score_range.hpp"

namespace symscene {
namespace {

constexpr float detection_cell_size = 0.01F;

/// The bound that a plane fails, in the order of judgement.
enum class PlaneOutcome { symmetry, inlier, occlusion, accepted };

PlaneOutcome judge_plane(const PlaneQuality& quality, const ReflectionalDetectionOptions& options) {
  if (quality.symmetry_score <= options.min_symmetry_score) return PlaneOutcome::symmetry;
  if (quality.inlier_score <= options.min_inlier_score) return PlaneOutcome::inlier;
  if (quality.occlusion_residual >= options.max_occlusion_residual) return PlaneOutcome::occlusion;
  return PlaneOutcome::accepted;
}

/// A plane of a segment with its quality.
struct ScoredTrial {
  ReflectionPlane plane;
  PlaneQuality quality;
};

void sort_by_occlusion(std::vector<ScoredTrial>& trials) {
  std::stable_sort(trials.begin(), trials.end(), [](const ScoredTrial& a, const ScoredTrial& b) {
    return std::tuple(a.quality.occlusion_residual, -a.quality.inlier_score) <
           std::tuple(b.quality.occlusion_residual, -b.quality.inlier_score);
  });
}

/// What a segment proposes, and how many planes reached each bound.
struct PlanesOfSegment {
  std::vector<ScoredTrial> accepted;
  std::array<std::size_t, 4> reached{};
  std::size_t tried = 0;
};

class SegmentDetector {
 public:
  SegmentDetector(const PointCloud& cloud, const PointIndices& segment, const DistanceField& field,
                  const ReflectionalDetectionOptions& options)
      : points_(select(cloud, segment)),
        cells_(points_.positions, detection_cell_size),
        sources_(evenly_spread(points_.size(), static_cast<Index>(options.max_points))),
        centroid_(centroid(points_.positions)),
        field_(field),
        options_(options) {}

  PlanesOfSegment detect(const std::optional<Eigen::Vector3d>& up) const {
    PlanesOfSegment result;
    const std::vector<ReflectionPlane> placed =
        placed_planes(points_, up, options_.fit.matching.min_plane_distance, options_.placement);
    result.tried = placed.size();
    for (const ReflectionPlane& plane : distinct_fits(placed)) {
      const ScoredTrial trial{plane,
                              plane_quality({points_, cells_}, sources_, plane, field_, options_)};
      const PlaneOutcome outcome = judge_plane(trial.quality, options_);
      for (std::size_t bound = 0; bound <= static_cast<std::size_t>(outcome); ++bound)
        ++result.reached[bound];
      if (outcome == PlaneOutcome::accepted) result.accepted.push_back(trial);
    }
    sort_by_occlusion(result.accepted);
    const SameSymmetry same{centroid_, options_.same_angle, options_.same_distance};
    result.accepted = without_repeats(
        std::move(result.accepted),
        [&](const ScoredTrial& a, const ScoredTrial& b) { return same(a.plane, b.plane); });
    return result;
  }

 private:
  /// Most planes converge to few within some rounds; only distinct ones are fitted to the end.
  std::vector<ReflectionPlane> distinct_fits(const std::vector<ReflectionPlane>& placed) const {
    const PlaneSearchOptions& search = options_.search;
    const PointIndices few =
        evenly_spread(points_.size(), static_cast<Index>(search.coarse_points));
    const std::vector<ReflectionPlane> coarse = without_repeats(
        fitted(placed, few, search.coarse_iterations),
        SameSymmetry{centroid_, search.coarse_same_angle, search.coarse_same_distance});
    return without_repeats(
        fitted(coarse, sources_, options_.fit.max_iterations),
        SameSymmetry{centroid_, search.fine_same_angle, search.fine_same_distance});
  }

  std::vector<ReflectionPlane> fitted(const std::vector<ReflectionPlane>& planes,
                                      const PointIndices& sources, int max_iterations) const {
    PlaneFitOptions fit_options = options_.fit;
    fit_options.max_iterations = std::min(max_iterations, options_.fit.max_iterations);
    std::vector<ReflectionPlane> fits;
    for (const ReflectionPlane& plane : planes) {
      const PlaneFit fit = fit_plane({points_, cells_}, sources, plane, fit_options);
      if (is_usable(fit.status)) fits.push_back(fit.plane);
    }
    return fits;
  }

  PointCloud points_;
  CellList cells_;
  PointIndices sources_;
  Eigen::Vector3d centroid_;
  const DistanceField& field_;
  const ReflectionalDetectionOptions& options_;
};

/// Of equal planes of neighbouring segments the one of lowest occlusion stays.
std::vector<ReflectionalCandidate> merge_equal_planes(std::vector<ReflectionalCandidate> candidates,
                                                      const PointCloud& cloud,
                                                      const ReflectionalDetectionOptions& options) {
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.quality.occlusion_residual, b.support.size()) <
           std::tuple(b.quality.occlusion_residual, a.support.size());
  });
  return distinct_candidates(
      std::move(candidates), cloud,
      {options.same_angle, options.same_distance, options.max_support_distance});
}

}  // namespace

void ReflectionalDetectionOptions::validate() const {
  check_fields(*this);
  require_score_ranges(*this);
}

ReflectionalDetection detect_reflectional(const PointCloud& cloud,
                                          const std::vector<PointIndices>& segments,
                                          const DistanceField& field,
                                          const std::optional<Eigen::Vector3d>& up,
                                          const ReflectionalDetectionOptions& options) {
  options.validate();
  std::vector<PlanesOfSegment> results(segments.size());
  parallel_for_each(segments.size(), [&](std::size_t s) {
    results[s] = SegmentDetector(cloud, segments[s], field, options).detect(up);
  });

  std::size_t tried = 0;
  std::array<std::size_t, 4> reached{};
  std::vector<ReflectionalCandidate> accepted;
  for (std::size_t s = 0; s < results.size(); ++s) {
    tried += results[s].tried;
    for (std::size_t bound = 0; bound < reached.size(); ++bound)
      reached[bound] += results[s].reached[bound];
    for (const ScoredTrial& trial : results[s].accepted)
      accepted.push_back({trial.plane, trial.quality, segments[s]});
  }
  ReflectionalDetection detection;
  detection.funnel = {{"reflectional: segments", segments.size()},
                      {"reflectional: planes tried", tried},
                      {"reflectional: distinct fits", reached[0]},
                      {"reflectional: normals agree", reached[1]},
                      {"reflectional: enough points matched", reached[2]},
                      {"reflectional: clear of free space", reached[3]},
                      {"reflectional: distinct in their segment", accepted.size()}};
  detection.candidates = merge_equal_planes(std::move(accepted), cloud, options);
  detection.funnel.push_back({"reflectional: distinct planes", detection.candidates.size()});
  return detection;
}

}  // namespace symscene
