#pragma once

#include "path_shortcuts.hpp"
#include "symscene/motion/trajectory.hpp"

namespace symscene {

/// The fastest motion along a free path of straight lines. Its corners are rounded as far as the
/// arcs are free too: `max_deviation` is halved until they are, at last to 0.
TimedPath checked_trajectory(const std::vector<Eigen::VectorXd>& path, const MotionLimits& limits,
                             TrajectoryOptions options, const MotionCheck& is_free);

}  // namespace symscene
