#include "symscene/motion/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "speed_profile.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

void require_limits(const char* name, const Eigen::VectorXd& limits, Eigen::Index joints) {
  if (limits.size() != joints) {
    throw InputError(fmt::format("{} limits", name), fmt::format("one per joint ({})", joints),
                     std::to_string(limits.size()));
  }
  for (Eigen::Index i = 0; i < joints; ++i) {
    if (!(limits[i] > 0.0) || !std::isfinite(limits[i])) {
      throw InputError(fmt::format("{} limit of joint {}", name, i), "a finite number above 0",
                       fmt::format("{}", limits[i]));
    }
  }
}

}  // namespace

TimedPath::TimedPath(JointPath path, std::vector<MotionPhase> phases)
    : path_(std::move(path)), phases_(std::move(phases)) {
  if (!phases_.empty()) duration_ = phases_.back().time + phases_.back().duration;
}

JointState TimedPath::at(double time) const {
  if (time >= duration_) return at_end();
  const double t = std::max(time, 0.0);
  auto phase = std::upper_bound(phases_.begin(), phases_.end(), t,
                                [](double value, const MotionPhase& p) { return value < p.time; });
  if (phase != phases_.begin()) --phase;
  const double elapsed = std::min(t - phase->time, phase->duration);
  const PathSegment& segment = path_.segments()[phase->segment];
  const double s = phase->s + elapsed * (phase->speed + 0.5 * phase->acceleration * elapsed);
  const double speed = std::max(phase->speed + phase->acceleration * elapsed, 0.0);
  const Eigen::VectorXd first = segment.first_derivative(s);
  return {t, segment.position(s), speed * first,
          phase->acceleration * first + speed * speed * segment.second_derivative(s)};
}

JointState TimedPath::at_end() const {
  const Eigen::VectorXd& last = path_.last();
  JointState state{duration_, last, Eigen::VectorXd::Zero(last.size()),
                   Eigen::VectorXd::Zero(last.size())};
  if (!phases_.empty()) {
    const PathSegment& segment = path_.segments()[phases_.back().segment];
    state.acceleration = phases_.back().acceleration * segment.first_derivative(segment.length);
  }
  return state;
}

TimedPath time_optimal_trajectory(const std::vector<Eigen::VectorXd>& waypoints,
                                  const MotionLimits& limits, const TrajectoryOptions& options) {
  options.validate();
  JointPath path(waypoints, options.max_deviation);
  require_limits("velocity", limits.velocity, path.first().size());
  require_limits("acceleration", limits.acceleration, path.first().size());
  std::vector<MotionPhase> phases = speed_profile(path, limits, options.arc_step);
  return {std::move(path), std::move(phases)};
}

std::vector<JointState> sampled(const TimedPath& trajectory, double period) {
  require_option(period > 0.0, "period", "a time above 0", period);
  std::vector<JointState> states{trajectory.at(0.0)};
  const double end = trajectory.duration();
  for (std::size_t i = 1; static_cast<double>(i) * period < end - 0.5 * period; ++i)
    states.push_back(trajectory.at(static_cast<double>(i) * period));
  if (end > 0.0) states.push_back(trajectory.at(end));
  return states;
}

}  // namespace symscene
