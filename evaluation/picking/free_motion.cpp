#include "free_motion.hpp"

#include <cmath>

namespace symscene {
namespace {

bool arcs_are_free(const MotionPlanner& planner, const JointPath& path) {
  constexpr double chord = 0.1;  // of an arc; it leaves the chord by 0.1 % of the radius [rad]
  for (const PathSegment& segment : path.segments()) {
    if (segment.is_line()) continue;
    const double chords = std::ceil(segment.length / segment.radius / chord);
    for (double i = 0.0; i < chords; i += 1.0) {
      if (!planner.collision.is_free(segment.position(segment.length * i / chords),
                                     segment.position(segment.length * (i + 1.0) / chords),
                                     planner.ignored))
        return false;
    }
  }
  return true;
}

}  // namespace

TimedPath timed_motion(const MotionPlanner& planner, const std::vector<Eigen::VectorXd>& path) {
  TrajectoryOptions options;
  if (!arcs_are_free(planner, JointPath(path, options.max_deviation))) options.max_deviation = 0.0;
  return time_optimal_trajectory(path, planner.limits, options);
}

FreeMotion plan_free_motion(const MotionPlanner& planner, const Eigen::VectorXd& start,
                            const std::vector<Eigen::VectorXd>& goals) {
  if (goals.empty()) return {std::nullopt, "no joint positions there are free"};
  const ArmCollision& collision = planner.collision;
  const MotionValidity validity{[&](const Eigen::VectorXd& q) {
                                  const auto met = collision.contact(q, planner.ignored);
                                  return met ? describe(*met) : std::string();
                                },
                                [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
                                  return collision.is_free(a, b, planner.ignored);
                                }};
  const PathResult found = rrt_connect(planner.space, start, goals, validity, planner.rrt);
  if (found.status != PathStatus::found)
    return {std::nullopt, found.obstacle.empty() ? "no path was found" : found.obstacle};
  return {timed_motion(planner, found.waypoints), {}};
}

}  // namespace symscene
