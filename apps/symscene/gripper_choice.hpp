#pragma once

#include <string>

#include "arguments.hpp"
#include "symscene/core/gripper.hpp"
#include "symscene/robots/robot.hpp"

namespace symscene::app {

/// The gripper that a command plans for: --gripper.
struct GripperChoice {
  std::string name = "panda";

  void add_to(Arguments& arguments);
  /// A built-in gripper, or that of a file. Throws InputError if there is none of that name or the
  /// file is invalid.
  Gripper gripper() const;
};

/// Whether the arm's description has a gripper, and that one by its name.
bool has_gripper(const RobotArm& arm, const Gripper& gripper);

}  // namespace symscene::app
