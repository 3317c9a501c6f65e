#include "gripper_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/file_names.hpp"
#include "symscene/core/error.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/io/gripper.hpp"

namespace symscene::app {

void GripperChoice::add_to(Arguments& arguments) {
  arguments.text("--gripper", "NAME|FILE", name,
                 fmt::format("{}, or a JSON or YAML file that describes a gripper (default panda)",
                             fmt::join(gripper_names(), ", ")));
}

Gripper GripperChoice::gripper() const {
  if (is_gripper_file(name)) return read_gripper(name);
  try {
    return named_gripper(name);
  } catch (const InputError& error) {
    throw InputError("--gripper", error.expected() + " or a .json or .yaml file", error.found());
  }
}

bool has_gripper(const RobotArm& arm, const Gripper& gripper) {
  return arm.gripper && GripperChoice{*arm.gripper}.gripper().name == gripper.name;
}

}  // namespace symscene::app
