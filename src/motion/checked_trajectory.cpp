#include "checked_trajectory.hpp"

#include <algorithm>
#include <cmath>

namespace symscene {
namespace {

bool arcs_are_free(const JointPath& path, const MotionCheck& is_free) {
  constexpr double chord = 0.1;  // of an arc; it leaves the chord by 0.1 % of the radius [rad]
  for (const PathSegment& segment : path.segments()) {
    if (segment.is_line()) continue;
    const double chords = std::ceil(segment.length / segment.radius / chord);
    for (double i = 0.0; i < chords; i += 1.0) {
      if (!is_free(segment.position(segment.length * i / chords),
                   segment.position(segment.length * (i + 1.0) / chords)))
        return false;
    }
  }
  return true;
}

}  // namespace

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
