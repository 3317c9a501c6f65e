#include "symmetry/plane_fit.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <Eigen/Dense>

#include "symmetry/point_residuals.hpp"

namespace symscene {
namespace {

constexpr std::size_t min_correspondences = 6;
constexpr double shift_damping = 1e-3;  ///< per match, as PlaneFitOptions::turn_damping

/// The cosine of two normals as matches count it: nearly opposite ones are the two sides of a thin
/// wall and count as equal where fold_thin_walls is set.
class MatchCosine {
 public:
  explicit MatchCosine(const CorrespondenceOptions& options)
      : folds_(options.fold_thin_walls),
        fold_cosine_(static_cast<float>(std::cos(options.min_fold_angle))) {}
  float operator()(float cosine) const {
    return folds_ && cosine < fold_cosine_ ? -cosine : cosine;
  }

 private:
  bool folds_;
  float fold_cosine_;
};

/// A plane by its normal and its offset from a reference point, the centre of its rotations.
struct LocalPlane {
  Eigen::Vector3d normal;
  double offset;  ///< n · (x − reference) = offset

  double distance(const Eigen::Vector3d& q) const { return normal.dot(q) - offset; }
};

/// The step (two rotations, one shift) that minimises the distances of reflections from the tangent
/// planes of their matches (Eq. 3.7). Rotations and shifts that the matches leave open (a flat face
/// slid in its own plane) stay small.
Eigen::Vector3d solve_step(const PointCloud& cloud, const std::vector<Correspondence>& matches,
                           const Eigen::Vector3d& reference, const LocalPlane& plane,
                           const Eigen::Matrix<double, 3, 2>& basis,
                           const PlaneFitOptions& options) {
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (const Correspondence& match : matches) {
    const Eigen::Vector3d q = cloud.position(match.from).cast<double>() - reference;
    const Eigen::Vector3d target = cloud.position(match.to).cast<double>() - reference;
    const Eigen::Vector3d target_normal = cloud.normal(match.to).cast<double>();
    const double distance = plane.distance(q);
    const double residual = target_normal.dot(q - 2.0 * distance * plane.normal - target);
    // S(q) = q − 2 (n · q − o) n, so that dr = −2 [(n' · n)(q · δn − δo) + (n · q − o)(n' · δn)]
    const double cosine = target_normal.dot(plane.normal);
    Eigen::Vector3d jacobian;
    jacobian << -2.0 * basis.transpose() * (cosine * q + distance * target_normal), 2.0 * cosine;
    hessian += jacobian * jacobian.transpose();
    gradient += residual * jacobian;
  }
  hessian.diagonal() += static_cast<double>(matches.size()) *
                        Eigen::Vector3d(options.turn_damping, options.turn_damping, shift_damping);
  return hessian.ldlt().solve(-gradient);
}

}  // namespace

ReflectionMatcher::ReflectionMatcher(const IndexedCloud& target, std::span<const Index> sources,
                                     const CorrespondenceOptions& options)
    : target_(target),
      sources_(sources),
      options_(options),
      last_(sources.size(), CellList::none) {}

float ReflectionMatcher::reach(std::size_t k, const Eigen::Vector3f& reflected) const {
  constexpr float rounding = 1.0F + 1e-5F;
  const auto radius = static_cast<float>(options_.max_distance);
  if (last_[k] == CellList::none) return radius;
  return std::min(radius, rounding * (target_.cloud.position(last_[k]) - reflected).norm());
}

std::vector<Correspondence> ReflectionMatcher::match(const ReflectionPlane& plane) {
  const PointCloud& cloud = target_.cloud;
  const PlaneReflector reflector(plane);
  const MatchCosine match_cosine(options_);
  const auto min_plane_distance = static_cast<float>(options_.min_plane_distance);
  const auto min_cosine = static_cast<float>(std::cos(options_.max_angle));
  std::vector<Correspondence> correspondences;
  correspondences.reserve(sources_.size());
  for (std::size_t k = 0; k < sources_.size(); ++k) {
    const Index from = sources_[k];
    const Eigen::Vector3f p = cloud.position(from);
    if (std::abs(reflector.signed_distance(p)) < min_plane_distance) continue;
    const Eigen::Vector3f reflected = reflector.point(p);
    const auto [to, squared_distance] = target_.cells.nearest(reflected, reach(k, reflected));
    if (to == CellList::none) continue;
    last_[k] = to;
    const float cosine =
        match_cosine(reflector.direction(cloud.normal(from)).dot(cloud.normal(to)));
    if (cosine >= min_cosine) correspondences.push_back({from, to, squared_distance, cosine});
  }
  return correspondences;
}

std::vector<Correspondence> reflect_onto(const IndexedCloud& target, std::span<const Index> sources,
                                         const ReflectionPlane& plane,
                                         const CorrespondenceOptions& options) {
  return ReflectionMatcher(target, sources, options).match(plane);
}

std::vector<Correspondence> one_to_one(const std::vector<Correspondence>& correspondences) {
  Index targets = 0;
  for (const Correspondence& match : correspondences) targets = std::max(targets, match.to + 1);
  std::vector<const Correspondence*> nearest(targets, nullptr);
  for (const Correspondence& match : correspondences) {
    const Correspondence*& best = nearest[match.to];
    if (best == nullptr || std::tuple(match.squared_distance, match.from) <
                               std::tuple(best->squared_distance, best->from))
      best = &match;
  }
  std::vector<Correspondence> kept;
  kept.reserve(correspondences.size());
  for (const Correspondence* match : nearest) {
    if (match != nullptr) kept.push_back(*match);
  }
  return kept;
}

PlaneFit fit_plane(const IndexedCloud& target, std::span<const Index> sources,
                   const ReflectionPlane& initial, const PlaneFitOptions& options) {
  options.validate();
  const PointCloud& cloud = target.cloud;
  const Eigen::Vector3d reference = centroid(cloud.positions, sources);
  LocalPlane plane{initial.normal, initial.normal.dot(initial.point - reference)};
  const auto as_plane = [&] {
    return ReflectionPlane{reference + plane.offset * plane.normal, plane.normal};
  };
  ReflectionMatcher matcher(target, sources, options.matching);
  PlaneFit fit;
  fit.status = FitStatus::iteration_limit;
  for (int iteration = 0; iteration < options.max_iterations; ++iteration) {
    const std::vector<Correspondence> matches = one_to_one(matcher.match(as_plane()));
    fit.correspondences = matches.size();
    if (matches.size() < min_correspondences) {
      fit.status = FitStatus::too_few_points;
      break;
    }
    const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(plane.normal);
    const Eigen::Vector3d step = solve_step(cloud, matches, reference, plane, basis, options);
    if (!step.allFinite()) {
      fit.status = FitStatus::degenerate;
      break;
    }
    plane.normal = (plane.normal + basis * step.head<2>()).normalized();
    plane.offset += step.z();
    if (step.head<2>().norm() < options.angle_tolerance &&
        std::abs(step.z()) < options.distance_tolerance) {
      fit.status = FitStatus::converged;
      break;
    }
  }
  fit.plane = as_plane();
  return fit;
}

}  // namespace symscene
