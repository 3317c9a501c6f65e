#include "checked_trajectory.hpp"

#include "motion/free_arcs.hpp"

namespace symscene {
TimedPath checked_trajectory(const std::vector<Eigen::VectorXd>& path, const MotionLimits& limits,
                             TrajectoryOptions options, const MotionCheck& is_free) {
  constexpr int halvings = 5;
  for (int i = 0; i < halvings; ++i) {
    if (arcs_are_free(JointPath(path, options.max_deviation), is_free))
      return time_optimal_trajectory(path, limits, options);
    options.max_deviation *= 0.5;
  }
  options.max_deviation = 0.0;
  return time_optimal_trajectory(path, limits, options);
}

}  // namespace symscene
