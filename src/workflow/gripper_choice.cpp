#include "workflow/gripper_choice.hpp"

#include "io/file_names.hpp"
#include "symscene/core/error.hpp"
#include "symscene/grasping/gripper.hpp"
#include "symscene/io/gripper.hpp"

namespace symscene {

Gripper chosen_gripper(const std::string& name_or_file, const std::string& where) {
  if (is_gripper_file(name_or_file)) return read_gripper(name_or_file);
  try {
    return named_gripper(name_or_file);
  } catch (const InputError& error) {
    throw InputError(where, error.expected() + " or a .json or .yaml file", error.found());
  }
}

}  // namespace symscene
