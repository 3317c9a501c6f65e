#include "gripper_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "symscene/grasping/gripper.hpp"
#include "workflow/gripper_choice.hpp"

namespace symscene::app {

void GripperChoice::add_to(Arguments& arguments) {
  arguments.text("--gripper", "NAME|FILE", name,
                 fmt::format("{}, or a JSON or YAML file that describes a gripper (default panda)",
                             fmt::join(gripper_names(), ", ")));
}

Gripper GripperChoice::gripper() const { return chosen_gripper(name, "--gripper"); }

bool has_gripper(const RobotArm& arm, const Gripper& gripper) {
  return arm.gripper && GripperChoice{*arm.gripper}.gripper().name == gripper.name;
}

}  // namespace symscene::app
