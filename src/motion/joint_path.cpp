#include "symscene/motion/joint_path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

constexpr double same_point = 1e-9;       // distance of waypoints that are one
constexpr double smallest_radius = 1e-6;  // of an arc; tighter corners are stops

void require_waypoints(const std::vector<Eigen::VectorXd>& waypoints) {
  if (waypoints.empty()) throw InputError("waypoints", "at least one", "none");
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const std::string where = fmt::format("waypoint {}", i);
    if (waypoints[i].size() != waypoints[0].size() || waypoints[i].size() == 0) {
      throw InputError(
          where,
          fmt::format("as many joints as in the first ({}), at least one", waypoints[0].size()),
          std::to_string(waypoints[i].size()));
    }
    if (!waypoints[i].allFinite()) throw InputError(where, "finite numbers", "others");
  }
}

double distance_from_line(const Eigen::VectorXd& point, const Eigen::VectorXd& a,
                          const Eigen::VectorXd& b) {
  const Eigen::VectorXd along = b - a;
  const double share = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - a - share * along).norm();
}

/// Whether a waypoint between two others changes nothing.
bool is_superfluous(const Eigen::VectorXd& before, const Eigen::VectorXd& point,
                    const Eigen::VectorXd& after) {
  return (after - before).norm() > same_point &&
         distance_from_line(point, before, after) < same_point;
}

std::vector<Eigen::VectorXd> without_repeats(const std::vector<Eigen::VectorXd>& waypoints) {
  std::vector<Eigen::VectorXd> kept{waypoints.front()};
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const bool is_last = i + 1 == waypoints.size();
    if ((waypoints[i] - kept.back()).norm() > same_point)
      kept.push_back(waypoints[i]);
    else if (is_last && kept.size() > 1)
      kept.back() = waypoints[i];  // the path ends exactly where it should
  }
  return kept;
}

std::vector<Eigen::VectorXd> simplified(const std::vector<Eigen::VectorXd>& waypoints) {
  const std::vector<Eigen::VectorXd> distinct = without_repeats(waypoints);
  std::vector<Eigen::VectorXd> kept;
  for (std::size_t i = 0; i < distinct.size(); ++i) {
    const bool is_inside = i > 0 && i + 1 < distinct.size();
    if (!is_inside || !is_superfluous(kept.back(), distinct[i], distinct[i + 1]))
      kept.push_back(distinct[i]);
  }
  return kept;
}

/// The arc that rounds a corner between two lines; none if it would be too tight.
std::optional<PathSegment> blend(const Eigen::VectorXd& before, const Eigen::VectorXd& corner,
                                 const Eigen::VectorXd& after, double max_deviation) {
  const Eigen::VectorXd in = (corner - before).normalized();
  const Eigen::VectorXd out = (after - corner).normalized();
  // tan(α/2) of the angle α by which the direction turns: no cancellation at small angles.
  const double tangent = (out - in).norm() / std::max((out + in).norm(), 1e-300);
  const double angle = 2.0 * std::atan(tangent);
  const double shorter = 0.5 * std::min((corner - before).norm(), (after - corner).norm());
  const double sine = std::sin(0.5 * angle);
  // Deviation δ = r (1/cos(α/2) − 1), distance from the corner ℓ = r tan(α/2): ℓ = δ sin / (1 −
  // cos).
  const double from_corner =
      std::min(shorter, max_deviation * sine / (2.0 * std::pow(std::sin(0.25 * angle), 2)));
  PathSegment arc;
  arc.radius = from_corner / tangent;
  if (!(arc.radius >= smallest_radius)) return std::nullopt;
  arc.start = corner - from_corner * in;
  arc.tangent = in;
  const Eigen::VectorXd sideways = out - out.dot(in) * in;
  arc.normal = (sideways - sideways.dot(in) * in).normalized();
  arc.length = arc.radius * angle;
  return arc;
}

}  // namespace

Eigen::VectorXd PathSegment::position(double s) const {
  if (is_line()) return start + s * tangent;
  const double half = std::sin(0.5 * s / radius);
  return start + radius * std::sin(s / radius) * tangent + 2.0 * radius * half * half * normal;
}

Eigen::VectorXd PathSegment::first_derivative(double s) const {
  if (is_line()) return tangent;
  return std::cos(s / radius) * tangent + std::sin(s / radius) * normal;
}

Eigen::VectorXd PathSegment::second_derivative(double s) const {
  if (is_line()) return Eigen::VectorXd::Zero(tangent.size());
  return (std::cos(s / radius) * normal - std::sin(s / radius) * tangent) / radius;
}

JointPath::JointPath(const std::vector<Eigen::VectorXd>& waypoints, double max_deviation) {
  require_waypoints(waypoints);
  require_option(max_deviation >= 0.0 && std::isfinite(max_deviation), "max_deviation",
                 "a number of at least 0", max_deviation);
  const std::vector<Eigen::VectorXd> corners = simplified(waypoints);
  first_ = corners.front();
  last_ = corners.back();
  Eigen::VectorXd from = first_;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const auto arc = blend(corners[i - 1], corners[i], corners[i + 1], max_deviation);
    add_line(from, arc ? arc->start : corners[i]);
    from = corners[i];
    if (!arc) {
      stops_.back() = true;
      continue;
    }
    segments_.push_back(*arc);
    stops_.push_back(false);
    const Eigen::VectorXd out = corners[i + 1] - corners[i];
    from += (corners[i] - arc->start).norm() / out.norm() * out;
  }
  if (corners.size() > 1) {
    add_line(from, last_);
    stops_.back() = true;
  }
}

void JointPath::add_line(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  PathSegment line;
  line.length = (to - from).norm();
  // Arcs that share a line halve it: what rounding leaves between them has no direction.
  if (line.length < 1e-12) return;
  line.start = from;
  line.tangent = (to - from) / line.length;
  segments_.push_back(line);
  stops_.push_back(false);
}

double JointPath::length() const {
  double sum = 0.0;
  for (const PathSegment& segment : segments_) sum += segment.length;
  return sum;
}

}  // namespace symscene
