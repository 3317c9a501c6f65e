#pragma once

#include <string>

#include "symscene/core/gripper.hpp"

namespace symscene {

/// The built-in gripper of that name, or that of a JSON or YAML file. Throws InputError, which
/// names `where` for an unknown name, if there is none or the file is invalid.
Gripper chosen_gripper(const std::string& name_or_file, const std::string& where);

}  // namespace symscene
