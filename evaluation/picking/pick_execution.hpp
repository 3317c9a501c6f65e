#pragma once

#include <string>

#include "arm_cell.hpp"
#include "symscene/motion/pick.hpp"
#include "symscene/picking/pick_run.hpp"

namespace symscene {

/// Motions that bring an object into the bin.
struct PlannedPick {
  Grasp grasp;
  PickMotion pick;
  TimedPath to_bin;
};

/// What came of a planned pick.
struct PickOutcome {
  AttemptEnd end = AttemptEnd::nothing_between_fingers;
  std::string detail;               ///< what the arm touched on its way
  std::vector<std::size_t> in_bin;  ///< objects that are in the bin now
};

/// Executes a planned pick. The arm stays where it ends, with the hand open. Throws
/// PhysicsDiverged.
PickOutcome execute_pick(ArmCell& cell, const Arm& arm, const PlannedPick& planned,
                         const PickExecutionOptions& options);

}  // namespace symscene
