#include "symscene/grasping/gripper.hpp"

#include <array>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

struct NamedGripper {
  std::string_view name;
  Gripper (*make)();
};
constexpr std::array<NamedGripper, 3> grippers{
    {{"panda", panda_hand}, {"baxter", baxter_electric_gripper}, {"reflex", reflex_gripper}}};

}  // namespace

Gripper panda_hand() {
  Gripper gripper;
  gripper.name = "panda";
  gripper.max_opening = 0.08;
  gripper.finger_depth = 0.05;
  gripper.finger_width = 0.021;
  gripper.finger_thickness = 0.026;
  gripper.tip_thickness = 0.014;
  gripper.palm_size = {0.064, 0.208, 0.092};
  gripper.T_wrist_tool.translation() = Eigen::Vector3d(0.0, 0.0, 0.062);
  return gripper;
}

Gripper baxter_electric_gripper() {
  Gripper gripper;
  gripper.name = "baxter";
  gripper.max_opening = 0.0417;
  gripper.finger_depth = 0.075;
  gripper.finger_width = 0.02;
  gripper.finger_thickness = 0.0135;
  gripper.tip_thickness = 0.0135;
  gripper.palm_size = {0.058, 0.14, 0.1};
  gripper.T_wrist_tool.translation() = Eigen::Vector3d(0.0, 0.0, 0.0225);
  return gripper;
}

Gripper reflex_gripper() {
  Gripper gripper;
  gripper.name = "reflex";
  gripper.kind = GripperKind::three_finger;
  gripper.max_opening = 0.16;
  gripper.finger_depth = 0.11;
  gripper.finger_width = 0.022;
  gripper.finger_thickness = 0.022;
  gripper.tip_thickness = 0.016;
  gripper.finger_spacing = 0.05;
  gripper.palm_size = {0.1, 0.12, 0.13};
  gripper.force = 10.0;
  gripper.T_wrist_tool.translation() = Eigen::Vector3d(0.0, 0.0, 0.13);
  return gripper;
}

std::vector<std::string_view> gripper_names() {
  std::vector<std::string_view> names;
  for (const NamedGripper& gripper : grippers) names.push_back(gripper.name);
  return names;
}

Gripper named_gripper(std::string_view name) {
  for (const NamedGripper& gripper : grippers) {
    if (gripper.name == name) return gripper.make();
  }
  throw InputError("gripper", fmt::format("one of {}", fmt::join(gripper_names(), ", ")),
                   fmt::format("\"{}\"", name));
}

}  // namespace symscene
