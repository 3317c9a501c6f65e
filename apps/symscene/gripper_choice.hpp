#pragma once

#include <string>

#include "arguments.hpp"
#include "symscene/core/gripper.hpp"

namespace symscene::app {

/// The gripper that a command plans for: --gripper.
struct GripperChoice {
  std::string name = "panda";

  void add_to(Arguments& arguments);
  /// A built-in gripper, or that of a file. Throws InputError if there is none of that name or the
  /// file is invalid.
  Gripper gripper() const;
};

}  // namespace symscene::app
