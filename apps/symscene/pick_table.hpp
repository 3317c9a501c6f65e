#pragma once

#include <span>
#include <string>

#include "symscene/core/grasp.hpp"
#include "symscene/motion/pick.hpp"

namespace symscene::app {

/// A table with one line per object that has grasps: how many the arm reaches, how many were not
/// tried, and for each reason how many it does not reach, with the detail of the first of these.
/// `reached` are indices into the grasps.
std::string format_reach(std::span<const Grasp> grasps, std::span<const std::size_t> reached,
                         std::span<const RejectedPick> rejected);

/// Which motion was planned: the object, its grasp, that of this number, and the times of the
/// motion's parts.
std::string format_motion(const PickMotion& motion, std::size_t number, const Grasp& grasp);

}  // namespace symscene::app
