#include "symscene/symmetry/reflectional_detection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr float cell_size = 0.01F;
constexpr Index placement_points = 200;

/// Keeps the normals of distinct planes, first come first kept.
std::vector<Eigen::Vector3d> without_repeats(const std::vector<Eigen::Vector3d>& normals) {
  std::vector<Eigen::Vector3d> distinct;
  for (const Eigen::Vector3d& normal : normals) {
    const bool repeats =
        std::any_of(distinct.begin(), distinct.end(),
                    [&](const Eigen::Vector3d& n) { return line_angle(n, normal) < radians(1.0); });
    if (!repeats) distinct.push_back(normal);
  }
  return distinct;
}

/// Plane normals in even steps of both spherical angles about the principal axes (section 3.5.3).
std::vector<Eigen::Vector3d> sphere_normals(const Eigen::Matrix3d& axes, int steps) {
  std::vector<Eigen::Vector3d> normals;
  const double step = std::numbers::pi / steps;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double polar = i * step;
      const double azimuth = j * step;
      normals.emplace_back(axes * Eigen::Vector3d(std::cos(polar),
                                                  std::sin(polar) * std::cos(azimuth),
                                                  std::sin(polar) * std::sin(azimuth)));
    }
  }
  return normals;
}

/// Normals of upright planes, beginning with the segment's longest horizontal extent.
std::vector<Eigen::Vector3d> upright_normals(const Eigen::Matrix3d& axes, const Eigen::Vector3d& up,
                                             int steps) {
  Eigen::Vector3d first = axes.col(0) - up.dot(axes.col(0)) * up;
  if (first.norm() < 0.1) first = axes.col(1) - up.dot(axes.col(1)) * up;
  first.normalize();
  const Eigen::Vector3d second = up.cross(first);
  std::vector<Eigen::Vector3d> normals;
  for (int i = 0; i < 2 * steps; ++i) {
    const double angle = i * std::numbers::pi / (2 * steps);
    normals.emplace_back(std::cos(angle) * first + std::sin(angle) * second);
  }
  return normals;
}

/// Where planes of one normal may stand: pairs of points that such a plane could swap vote for its
/// offset.
class OffsetVotes {
 public:
  OffsetVotes(const PointCloud& points, const Eigen::Vector3d& reference,
              const ReflectionalDetectionOptions& options)
      : min_cosine_(static_cast<float>(std::cos(options.shift_angle))),
        min_gap_(2.0F * static_cast<float>(options.fit.matching.min_plane_distance)),
        points_(select(points, evenly_spread(points.size(), placement_points))),
        radius_(reach(points, options.shift_radius)) {
    points_.positions.rowwise() -= reference.cast<float>().transpose();
  }

  /// The median offset (Eq. 3.8) of the planes that swap two points; zero without any.
  double median(const Eigen::Vector3d& plane_normal) const {
    const Eigen::Vector3f n = plane_normal.cast<float>();
    const Eigen::VectorXf heights = points_.positions * n;
    const Eigen::VectorXf facing = points_.normals * n;
    std::vector<float> offsets;
    for (Index i = 0; i < points_.size(); ++i) {
      for (Index j = 0; j < i; ++j) {
        const float gap = heights[i] - heights[j];
        if (std::abs(gap) < min_gap_) continue;
        const float squared_across =
            (points_.positions.row(i) - points_.positions.row(j)).squaredNorm() - gap * gap;
        if (squared_across > radius_ * radius_) continue;
        const float cosine =
            points_.normals.row(i).dot(points_.normals.row(j)) - 2.0F * facing[i] * facing[j];
        if (cosine > min_cosine_) offsets.push_back(0.5F * (heights[i] + heights[j]));
      }
    }
    if (offsets.empty()) return 0.0;
    const auto middle = offsets.begin() + static_cast<std::ptrdiff_t>(offsets.size() / 2);
    std::nth_element(offsets.begin(), middle, offsets.end());
    return double{*middle};
  }

 private:
  /// The thinner the points, the farther a partner may lie across the normal.
  static float reach(const PointCloud& points, double radius) {
    const double thinning =
        static_cast<double>(points.size()) / std::min(points.size(), placement_points);
    return static_cast<float>(radius * std::sqrt(std::max(1.0, 0.25 * thinning)));
  }

  float min_cosine_;
  float min_gap_;
  PointCloud points_;
  float radius_;
};

enum class Outcome { symmetry, inlier, occlusion, accepted };

Outcome judge(const ReflectionalScores& scores, const ReflectionalDetectionOptions& options) {
  if (scores.symmetry_score <= options.min_symmetry_score) return Outcome::symmetry;
  if (scores.inlier_score <= options.min_inlier_score) return Outcome::inlier;
  if (scores.occlusion_residual >= options.max_occlusion_residual) return Outcome::occlusion;
  return Outcome::accepted;
}

/// A plane while its segment is worked on.
struct Trial {
  ReflectionPlane plane;
  ReflectionalScores scores;
};

/// Drops each trial that nearly repeats one before it, seen from `here`.
std::vector<Trial> distinct_trials(const std::vector<Trial>& trials, const Eigen::Vector3d& here,
                                   double same_angle, double same_distance) {
  std::vector<Trial> distinct;
  for (const Trial& trial : trials) {
    const bool repeats = std::any_of(distinct.begin(), distinct.end(), [&](const Trial& other) {
      const SymmetryDifference apart = difference(trial.plane, other.plane, here);
      return apart.angle < same_angle && apart.distance < same_distance;
    });
    if (!repeats) distinct.push_back(trial);
  }
  return distinct;
}

void sort_by_occlusion(std::vector<Trial>& trials) {
  std::stable_sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
    return std::tuple(a.scores.occlusion_residual, -a.scores.inlier_score) <
           std::tuple(b.scores.occlusion_residual, -b.scores.inlier_score);
  });
}

/// What a segment proposes, with how many planes reached each bound.
struct SegmentResult {
  std::vector<Trial> accepted;
  std::array<std::size_t, 4> reached{};
  std::size_t tried = 0;
};

class SegmentDetector {
 public:
  SegmentDetector(const PointCloud& cloud, const PointIndices& segment, const DistanceField& field,
                  const ReflectionalDetectionOptions& options)
      : points_(select(cloud, segment)),
        cells_(points_.positions, cell_size),
        sources_(evenly_spread(points_.size(), static_cast<Index>(options.max_points))),
        centroid_(centroid(points_.positions)),
        field_(field),
        options_(options) {}

  SegmentResult detect(const std::optional<Eigen::Vector3d>& up) const {
    SegmentResult result;
    std::vector<Trial> trials = initial_trials(up);
    result.tried = trials.size();
    // Most starts run together within a few rounds; only what is still distinct is fitted to the
    // end.
    trials = distinct_trials(fitted(trials, 4), centroid_, radians(2.0), 0.003);
    trials = distinct_trials(fitted(trials, options_.fit.max_iterations), centroid_, radians(1.0),
                             0.002);
    for (Trial& trial : trials) {
      trial.scores = reflectional_scores(points_, cells_, sources_, trial.plane, field_, options_);
      const Outcome outcome = judge(trial.scores, options_);
      for (std::size_t bound = 0; bound <= static_cast<std::size_t>(outcome); ++bound) {
        ++result.reached[bound];
      }
      if (outcome == Outcome::accepted) result.accepted.push_back(trial);
    }
    sort_by_occlusion(result.accepted);
    result.accepted =
        distinct_trials(result.accepted, centroid_, options_.same_angle, options_.same_distance);
    return result;
  }

 private:
  std::vector<Trial> initial_trials(const std::optional<Eigen::Vector3d>& up) const {
    const Eigen::Matrix3d axes = principal_axes(points_.positions);
    std::vector<Eigen::Vector3d> normals = sphere_normals(axes, options_.azimuth_steps);
    if (up) {
      const std::vector<Eigen::Vector3d> upright =
          upright_normals(axes, *up, options_.azimuth_steps);
      normals.insert(normals.end(), upright.begin(), upright.end());
    }
    const OffsetVotes votes(points_, centroid_, options_);
    std::vector<Trial> trials;
    for (const Eigen::Vector3d& normal : without_repeats(normals)) {
      trials.push_back({{centroid_ + votes.median(normal) * normal, normal}, {}});
    }
    return trials;
  }

  std::vector<Trial> fitted(const std::vector<Trial>& trials, int max_iterations) const {
    PlaneFitOptions fit_options = options_.fit;
    fit_options.max_iterations = std::min(max_iterations, options_.fit.max_iterations);
    std::vector<Trial> fits;
    for (const Trial& trial : trials) {
      const PlaneFit fit = fit_plane(points_, cells_, sources_, trial.plane, fit_options);
      if (is_usable(fit.status)) fits.push_back({fit.plane, {}});
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

/// Over the whole scene: of equal planes of neighbouring segments the least occluded stays.
std::vector<ReflectionalCandidate> merge_equal_planes(std::vector<ReflectionalCandidate> candidates,
                                                      const PointCloud& cloud,
                                                      const ReflectionalDetectionOptions& options) {
  constexpr double one_object = 0.3;  // segments farther apart belong to two objects in a row
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.scores.occlusion_residual, b.support.size()) <
           std::tuple(b.scores.occlusion_residual, a.support.size());
  });
  std::vector<ReflectionalCandidate> distinct;
  std::vector<Eigen::Vector3d> centroids;
  for (ReflectionalCandidate& candidate : candidates) {
    const Eigen::Vector3d here = centroid(cloud.positions, candidate.support);
    bool repeats = false;
    for (std::size_t k = 0; k < distinct.size() && !repeats; ++k) {
      const SymmetryDifference apart = difference(candidate.plane, distinct[k].plane, here);
      repeats = apart.angle < options.same_angle && apart.distance < options.same_distance &&
                (here - centroids[k]).norm() < one_object;
    }
    if (repeats) continue;
    distinct.push_back(std::move(candidate));
    centroids.push_back(here);
  }
  return distinct;
}

}  // namespace

void ReflectionalDetectionOptions::validate() const {
  fit.validate();
  scoring.validate();
  require_option(azimuth_steps >= 1 && azimuth_steps <= 90, "azimuth_steps", "1 to 90",
                 azimuth_steps);
  require_option(max_points >= 8, "max_points", "at least 8 points", max_points);
  require_option(shift_radius > 0.0, "shift_radius", "a length above 0 m", shift_radius);
  require_score_ranges(*this);
  require_option(shift_angle > 0.0 && shift_angle < std::numbers::pi, "shift_angle",
                 "an angle in (0, pi) rad", shift_angle);
  require_option(max_angle <= std::numbers::pi, "max_angle", "an angle of at most pi rad",
                 max_angle);
  require_option(min_symmetry_score >= 0.0 && min_symmetry_score <= 1.0, "min_symmetry_score",
                 "a score in [0, 1]", min_symmetry_score);
  require_option(min_inlier_score >= 0.0 && min_inlier_score <= 1.0, "min_inlier_score",
                 "a score in [0, 1]", min_inlier_score);
  require_option(max_occlusion_residual >= 0.0 && max_occlusion_residual <= 1.0,
                 "max_occlusion_residual", "a score in [0, 1]", max_occlusion_residual);
  require_option(same_angle >= 0.0, "same_angle", "an angle of at least 0 rad", same_angle);
  require_option(same_distance >= 0.0, "same_distance", "a distance of at least 0 m",
                 same_distance);
}

ReflectionalScores reflectional_scores(const PointCloud& cloud, const CellList& cells,
                                       std::span<const Index> members, const ReflectionPlane& plane,
                                       const DistanceField& field,
                                       const ReflectionalDetectionOptions& options) {
  if (members.empty()) return {0.0, 0.0, 1.0};
  const std::vector<Correspondence> matches =
      one_to_one(reflect_onto(cloud, cells, members, plane, options.scoring));
  const ScoreRange angle_range = options.angle_range();
  double agreement = 0.0;
  for (const Correspondence& match : matches) agreement += 1.0 - double{angle_range(match.angle)};
  const PlaneReflector reflector(plane);
  const ScoreRange occlusion_range = options.occlusion_range();
  double occlusion = 0.0;
  for (const Index i : members) {
    occlusion += double{occlusion_range(field.at(reflector.point(cloud.position(i))))};
  }
  const auto count = static_cast<double>(members.size());
  const double symmetry = matches.empty() ? 0.0 : agreement / static_cast<double>(matches.size());
  return {symmetry, agreement / count, occlusion / count};
}

ReflectionalDetection detect_reflectional(const PointCloud& cloud,
                                          const std::vector<PointIndices>& segments,
                                          const DistanceField& field,
                                          const std::optional<Eigen::Vector3d>& up,
                                          const ReflectionalDetectionOptions& options) {
  options.validate();
  std::vector<SegmentResult> results(segments.size());
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
    for (const Trial& trial : results[s].accepted)
      accepted.push_back({trial.plane, trial.scores, segments[s]});
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
