#pragma once

#include <string>

#include "symscene/core/grasp.hpp"

namespace symscene::app {

/// A table with one line per object: its grasps, the best of them, or why it has none.
std::string format_grasps(const GraspPlan& plan);

/// The number of objects with a grasp.
std::size_t graspable_objects(const GraspPlan& plan);

}  // namespace symscene::app
