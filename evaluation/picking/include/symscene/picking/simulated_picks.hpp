#pragma once

#include <functional>
#include <string>

#include "symscene/picking/pick_run.hpp"
#include "symscene/picking/pick_table.hpp"
#include "symscene/picking/simulated_pick_options.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene {

/// What is told while a run goes on; each may be empty.
struct PickObserver {
  StageTimer::OnBegin on_stage;                        ///< a stage begins
  std::function<void(const RecordedEvent&)> on_event;  ///< something happened
};

/// Clears a table in physics: the robot's grasping arm puts objects into a bin beside the table
/// until none is left that it can take. Each round:
///
/// 1. The arm with the robot's camera moves it past the table. Images are rendered of the true
///    scene; pixels that show the robot or the bin are left out, as the robot knows their shapes.
///    The pose of the first image is the arm's; all others are found by tracking, which starts
///    from the arm's pose.
///    Without a camera in the robot's description, one flies along the same arc.
/// 2. Scene, objects with completed shapes, grasps, and motions: to a grasp, back, and to the bin.
/// 3. The arm follows them. The approach stops at the first contact, the fingers close until they
///    meet the object. An object in the bin is taken out of the physics.
///
/// Objects on which attempts failed are tried after all others. A place at which max_failures
/// attempts failed is not tried again, nor an object after max_object_failures. The same input
/// gives the same run, apart from wall times. Throws InputError if an option, the robot's arm or
/// its gripper is invalid, an object has no volume, or this build has no physics.
PickRun simulate_picks(const PickTable& table, const Robot& robot, const Gripper& gripper,
                       const SimulatedPickOptions& options = {}, const PickObserver& observer = {});

}  // namespace symscene
