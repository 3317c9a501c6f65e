#include "free_motion.hpp"

#include "motion/free_arcs.hpp"
#include "symscene/motion/motion_validity.hpp"

namespace symscene {

TimedPath timed_motion(const MotionPlanner& planner, const std::vector<Eigen::VectorXd>& path) {
  TrajectoryOptions options;
  if (!arcs_are_free(JointPath(path, options.max_deviation),
                     motion_validity(planner.collision, planner.ignored).is_free))
    options.max_deviation = 0.0;
  return time_optimal_trajectory(path, planner.limits, options);
}

FreeMotion plan_free_motion(const MotionPlanner& planner, const Eigen::VectorXd& start,
                            const std::vector<Eigen::VectorXd>& goals) {
  if (goals.empty()) return {std::nullopt, "no joint positions there are free"};
  const PathResult found =
      rrt_connect(planner.space, start, goals, motion_validity(planner.collision, planner.ignored),
                  planner.rrt);
  if (found.status != PathStatus::found)
    return {std::nullopt, found.obstacle.empty() ? "no path was found" : found.obstacle};
  return {timed_motion(planner, found.waypoints), {}, found.waypoints};
}

MotionLimits slowed(const MotionLimits& limits, double factor) {
  return {limits.velocity / factor, limits.acceleration / (factor * factor)};
}

}  // namespace symscene
