#include "curve_matching.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "plane_mode.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// A pair of points within the bounds, and the plane that reflects one to the other.
struct PointPair {
  CurveCorrespondence points;
  MirrorSample plane;
};

Eigen::Vector3d reflected(const Eigen::Vector3d& direction, const Eigen::Vector3d& normal) {
  return direction - 2.0 * normal.dot(direction) * normal;
}

/// The mean of the points of both curves.
Eigen::Vector3d common_centroid(const EdgeCurve& a, const EdgeCurve& b) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const EdgeCurve* curve : {&a, &b})
    for (const EdgeCurve::Point& point : curve->points) sum += point.position;
  return sum / static_cast<double>(a.points.size() + b.points.size());
}

/// Eqs. 3.1 to 3.3, the plane's offset being that of the midpoint from `centre`.
std::optional<PointPair> point_pair(const EdgeCurve::Point& a, const EdgeCurve::Point& b,
                                    const Eigen::Vector3d& centre,
                                    const CurveMatchingOptions& options) {
  const Eigen::Vector3d between = a.position - b.position;
  const double distance = between.norm();
  if (distance < options.min_distance || distance > options.max_distance) return std::nullopt;
  const Eigen::Vector3d normal = between / distance;
  const double angle = line_angle(a.tangent, reflected(b.tangent, normal));
  if (angle > options.max_angle) return std::nullopt;
  const Eigen::Vector3d middle = 0.5 * (a.position + b.position);
  return PointPair{{0, 0, angle}, {normal, normal.dot(middle - centre)}};
}

/// All pairs of points within the bounds; of a curve with itself each pair once.
std::vector<PointPair> point_pairs(const EdgeCurve& a, const EdgeCurve& b,
                                   const Eigen::Vector3d& centre,
                                   const CurveMatchingOptions& options) {
  const bool is_same = &a == &b;
  std::vector<PointPair> pairs;
  for (Index i = 0; i < a.points.size(); ++i) {
    for (Index j = is_same ? i + 1 : 0; j < b.points.size(); ++j) {
      std::optional<PointPair> pair = point_pair(a.points[i], b.points[j], centre, options);
      if (!pair) continue;
      pair->points.a = i;
      pair->points.b = j;
      pairs.push_back(*pair);
    }
  }
  return pairs;
}

/// The pairs whose plane is `mode`, nearest first, each point in at most one.
std::vector<CurveCorrespondence> one_to_one_pairs(const std::vector<PointPair>& pairs,
                                                  const MirrorSample& mode,
                                                  const PlaneKernel& kernel, const EdgeCurve& a,
                                                  const EdgeCurve& b) {
  std::vector<std::tuple<double, std::size_t>> near;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const double distance = kernel.squared_distance(pairs[k].plane, mode);
    if (distance <= 1.0) near.emplace_back(distance, k);
  }
  std::sort(near.begin(), near.end());
  std::vector<bool> used_a(a.points.size(), false), used_b(b.points.size(), false);
  std::vector<bool>& used_second = &a == &b ? used_a : used_b;
  std::vector<CurveCorrespondence> kept;
  for (const auto& [distance, k] : near) {
    const CurveCorrespondence& points = pairs[k].points;
    if (used_a[points.a] || used_second[points.b]) continue;
    used_a[points.a] = true;
    used_second[points.b] = true;
    kept.push_back(points);
  }
  return kept;
}

/// The number of points of both curves.
double point_count(const EdgeCurve& a, const EdgeCurve& b) {
  return static_cast<double>(&a == &b ? a.points.size() : a.points.size() + b.points.size());
}

}  // namespace

void CurveMatchingOptions::validate() const {
  check_fields(*this);
  require_option(max_distance > min_distance, "max_distance", "a distance above min_distance",
                 max_distance);
}

BoundedCurve::BoundedCurve(const EdgeCurve& bounded)
    : curve(&bounded), centre(common_centroid(bounded, bounded)) {
  tangent = bounded.points[bounded.points.size() / 2].tangent;
  for (const EdgeCurve::Point& point : bounded.points) {
    radius = std::max(radius, (point.position - centre).norm());
    tangent_spread = std::max(tangent_spread, line_angle(tangent, point.tangent));
  }
}

bool may_match(const BoundedCurve& a, const BoundedCurve& b, const CurveMatchingOptions& options) {
  const double count = point_count(*a.curve, *b.curve);
  const auto fewest = static_cast<double>(std::min(a.curve->points.size(), b.curve->points.size()));
  if (fewest < options.min_inlier_ratio * count) return false;
  const Eigen::Vector3d between = a.centre - b.centre;
  const double distance = between.norm();
  const double reach = a.radius + b.radius;
  if (distance - reach > options.max_distance) return false;
  if (distance <= reach) return true;
  const double spread =
      options.max_angle + a.tangent_spread + b.tangent_spread + 2.0 * std::asin(reach / distance);
  return std::abs(line_angle(a.tangent, between) - line_angle(b.tangent, between)) <= spread;
}

std::optional<CurveMatch> match_curves(const EdgeCurve& a, const EdgeCurve& b,
                                       const CurveMatchingOptions& options) {
  const Eigen::Vector3d centre = common_centroid(a, b);
  const std::vector<PointPair> pairs = point_pairs(a, b, centre, options);
  if (pairs.size() < static_cast<std::size_t>(options.min_correspondences)) return std::nullopt;
  std::vector<MirrorSample> samples;
  for (const PointPair& pair : pairs) samples.push_back(pair.plane);
  const PlaneKernel kernel{options.angle_bandwidth, options.offset_bandwidth};
  const std::optional<MirrorSample> mode = dominant_plane(samples, kernel, options.max_starts);
  if (!mode) return std::nullopt;
  CurveMatch match;
  match.plane = {centre + mode->offset * mode->normal, mode->normal};
  match.correspondences = one_to_one_pairs(pairs, *mode, kernel, a, b);
  match.inlier_ratio = static_cast<double>(match.correspondences.size()) / point_count(a, b);
  const bool enough =
      match.correspondences.size() >= static_cast<std::size_t>(options.min_correspondences) &&
      match.inlier_ratio >= options.min_inlier_ratio;
  return enough ? std::optional(std::move(match)) : std::nullopt;
}

}  // namespace symscene
