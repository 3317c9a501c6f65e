#pragma once

#include <string>

#include "symscene/core/grasp.hpp"
#include "symscene/core/gripper.hpp"

namespace symscene {

/// The text of grasps.json (docs/formats.md, docs/grasps.schema.json): the plan and the gripper for
/// which it was made. Each grasp has two poses, of the tool frame and of the wrist. Equal plans
/// give equal bytes; without timings (`with_timings` false), runs on equal input do. Throws
/// InputError if a number is not finite.
std::string format_grasps_json(const GraspPlan& plan, const Gripper& gripper,
                               bool with_timings = true);

}  // namespace symscene
