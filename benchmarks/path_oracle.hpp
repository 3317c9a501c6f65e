#pragma once

#include "symscene/motion/rrt_connect.hpp"

namespace symscene::bench {

/// Whether OMPL is built in.
bool has_path_oracle();

/// Whether OMPL's RRTConnect finds a path between two configurations within a time. [s] The same
/// validity is asked as by ours. Continuous joints are searched within ±π. Throws InputError
/// without OMPL.
bool oracle_finds_path(const JointSpace& space, const Eigen::VectorXd& start,
                       const Eigen::VectorXd& goal, const MotionValidity& validity, double seconds);

}  // namespace symscene::bench
