#include "symscene/robots/robot.hpp"

#include <algorithm>

#include "core/nearest_name.hpp"
#include "symscene/core/error.hpp"

namespace symscene {

const RobotArm& Robot::grasping_arm() const {
  const auto found = std::find_if(arms.begin(), arms.end(),
                                  [](const RobotArm& arm) { return arm.gripper.has_value(); });
  if (found == arms.end()) throw InputError("robot " + model.name, "an arm with a gripper", "none");
  return *found;
}

const RobotArm& Robot::arm(std::string_view name) const {
  std::vector<std::string> names;
  for (const RobotArm& arm : arms) {
    if (arm.arm.name == name) return arm;
    names.push_back(arm.arm.name);
  }
  throw InputError("robot " + model.name, "the name of an arm", with_nearest_name(name, names));
}

}  // namespace symscene
