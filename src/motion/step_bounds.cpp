#include "step_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace symscene {

/// Where in a step a limit is looked at. Between its ends a function with second derivative f'' by
/// the angle exceeds its chord by at most |f''| angle² / 8.
struct StepBounds::Ends {
  double radius;
  double angle;     ///< of the step
  double advanced;  ///< 0 at its start, its length at its end: x there is x + 2 u advanced

  double excess() const { return angle * angle / 8.0; }
};

void StepBounds::set_arc(const PathSegment& arc, double begin, double end,
                         const MotionLimits& limits) {
  planes_.clear();
  most_ = std::numeric_limits<double>::infinity();
  step_ = end - begin;
  for (const double s : {begin, end}) {
    const Ends ends{arc.radius, step_ / arc.radius, s - begin};
    const double cosine = std::cos(s / arc.radius);
    const double sine = std::sin(s / arc.radius);
    for (Eigen::Index i = 0; i < arc.tangent.size(); ++i) {
      const double first = cosine * arc.tangent[i] + sine * arc.normal[i];
      const double second = (cosine * arc.normal[i] - sine * arc.tangent[i]) / arc.radius;
      const double amplitude = std::hypot(arc.tangent[i], arc.normal[i]);
      add_velocity(first, amplitude, limits.velocity[i], ends);
      add_acceleration(first, second, amplitude, limits.acceleration[i], ends);
    }
  }
}

void StepBounds::add_velocity(double derivative, double amplitude, double limit, const Ends& ends) {
  // q'² x ≤ v². By the angle its second derivative is at most A² (2 x + 4 r |u|), and x exceeds
  // that of this end by at most 2 r angle |u|.
  const double excess = amplitude * amplitude * ends.excess();
  const double of_x = derivative * derivative + 2.0 * excess;
  const double of_u = excess * 4.0 * ends.radius * (1.0 + ends.angle);
  add(of_x * 2.0 * ends.advanced, of_u, of_x, limit * limit);
  if (ends.advanced == 0.0) most_ = std::min(most_, limit * limit / of_x);
}

void StepBounds::add_acceleration(double first, double second, double amplitude, double limit,
                                  const Ends& ends) {
  // ±(q' u + q'' x) ≤ a. By the angle its second derivative is at most A (5 |u| + x / r).
  const double excess = amplitude * ends.excess();
  const double of_u = excess * (5.0 + 2.0 * ends.angle);
  for (const double sign : {1.0, -1.0}) {
    const double of_x = sign * second + excess / ends.radius;
    add(sign * first + of_x * 2.0 * ends.advanced, of_u, of_x, limit);
  }
}

void StepBounds::add(double p, double spread, double c, double d) {
  planes_.push_back({p + spread, c, d});
  planes_.push_back({p - spread, c, d});
}

void StepBounds::bound_end(double most) {
  planes_.push_back({2.0 * step_, 1.0, most});
  planes_.push_back({-2.0 * step_, -1.0, 0.0});
}

StepBounds::Line StepBounds::upper(double x) const {
  Line least{std::numeric_limits<double>::infinity(), 0.0};
  for (const HalfPlane& plane : planes_) {
    if (plane.p <= 0.0) continue;
    const Line line{plane.d / plane.p, -plane.c / plane.p};
    if (line.at(x) < least.at(x)) least = line;
  }
  return least;
}

StepBounds::Line StepBounds::lower(double x) const {
  Line greatest{-std::numeric_limits<double>::infinity(), 0.0};
  for (const HalfPlane& plane : planes_) {
    if (plane.p >= 0.0) continue;
    const Line line{plane.d / plane.p, -plane.c / plane.p};
    if (line.at(x) > greatest.at(x)) greatest = line;
  }
  return greatest;
}

double StepBounds::greatest_start() const {
  double x = most_;
  // Newton's method on the concave gap between upper and lower bound, from the right: finite, as
  // each step leaves a pair of lines for good.
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    const Line above = upper(x);
    const Line below = lower(x);
    if (above.at(x) >= below.at(x)) break;
    const double next = (above.offset - below.offset) / (below.slope - above.slope);
    if (!(next < x)) break;
    x = std::max(next, 0.0);
  }
  return x;
}

double StepBounds::greatest_acceleration(double x) const { return upper(x).at(x); }

}  // namespace symscene
