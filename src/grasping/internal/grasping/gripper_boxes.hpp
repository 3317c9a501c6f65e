#pragma once

#include <vector>

#include "symscene/core/gripper.hpp"

namespace symscene {

/// The palm and the fingers of a gripper as boxes of its tool frame. [m]
std::vector<Eigen::AlignedBox3d> gripper_boxes(const Gripper& gripper, double opening);

/// The space between the pads of its fingers, in the tool frame. [m]
Eigen::AlignedBox3d box_between_fingers(const Gripper& gripper, double opening);

}  // namespace symscene
