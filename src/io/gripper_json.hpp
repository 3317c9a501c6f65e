#pragma once

#include "io/json_cursor.hpp"
#include "symscene/core/gripper.hpp"

namespace symscene {

/// The gripper as JSON; `what` stands for the file in messages.
Json gripper_json(const Gripper& gripper, const char* what);
/// Reads it. Throws InputError if a member is missing, unknown or out of its range.
Gripper gripper_of(const JsonCursor& json);

}  // namespace symscene
