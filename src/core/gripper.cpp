#include "symscene/core/gripper.hpp"

#include "symscene/core/error.hpp"

namespace symscene {

const char* to_string(GripperKind kind) {
  return kind == GripperKind::parallel ? "parallel" : "three_finger";
}

std::optional<GripperKind> gripper_kind_of(std::string_view name) {
  for (const GripperKind kind : {GripperKind::parallel, GripperKind::three_finger}) {
    if (name == to_string(kind)) return kind;
  }
  return std::nullopt;
}

Eigen::Matrix3d tool_axes(const Eigen::Vector3d& closing, const Eigen::Vector3d& approach) {
  Eigen::Matrix3d R;
  R << closing.cross(approach), closing, approach;
  return R;
}

void Gripper::validate() const {
  check_fields(*this);
  require_option(max_opening > min_opening, "max_opening", "more than min_opening", max_opening);
  require_option(tip_thickness <= finger_thickness, "tip_thickness", "at most finger_thickness",
                 tip_thickness);
  if (kind == GripperKind::parallel) {
    require_option(finger_spacing == 0.0, "finger_spacing", "0 of a parallel gripper",
                   finger_spacing);
  } else {
    require_option(finger_spacing >= finger_width, "finger_spacing",
                   "at least finger_width, so that the fingers do not overlap", finger_spacing);
  }
  require_option(palm_size.minCoeff() >= 0.0 && palm_size.maxCoeff() <= 1.0, "palm_size",
                 "three edges in [0, 1] m", palm_size.minCoeff());
  require_option(T_wrist_tool.linear().allFinite(), "T_wrist_tool", "finite numbers",
                 T_wrist_tool.linear().norm());
  constexpr double farthest = 2.0;  // as two of the largest palm [m]
  const double distance = T_wrist_tool.translation().norm();
  require_option(distance <= farthest, "T_wrist_tool",
                 "an origin within 2 m of the wrist (are the units metres?)", distance);
}

}  // namespace symscene
