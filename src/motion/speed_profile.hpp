#pragma once

#include <vector>

#include "symscene/motion/trajectory.hpp"

namespace symscene {

/// The phases of the fastest motion along a path within the limits.
std::vector<MotionPhase> speed_profile(const JointPath& path, const MotionLimits& limits,
                                       double arc_step);

}  // namespace symscene
