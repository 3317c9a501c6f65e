#pragma once

#include <string_view>
#include <vector>

#include "symscene/core/gripper.hpp"

namespace symscene {

/// The hand of Franka's Panda: 80 mm, 20 N per finger. Boxes around the collision shapes of
/// franka_description; the wrist is the link panda_hand.
Gripper panda_hand();

/// Baxter's electric gripper with standard narrow fingers: a stroke of 41.7 mm (rethink_ee). The
/// wrist is the link *_gripper_base.
Gripper baxter_electric_gripper();

/// A three-finger hand of the ReFlex kind (section 4.6.1), as boxes with rounded dimensions.
Gripper reflex_gripper();

/// The names that named_gripper() knows: "panda", "baxter" and "reflex".
std::vector<std::string_view> gripper_names();

/// Throws InputError if no built-in gripper has that name.
Gripper named_gripper(std::string_view name);

}  // namespace symscene
