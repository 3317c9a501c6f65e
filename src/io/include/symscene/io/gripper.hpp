#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "symscene/core/gripper.hpp"

namespace symscene {

/// Parses a gripper file (docs/formats.md): JSON, or YAML if `file` ends in .yaml or .yml, whose
/// members name their units. Members that are
/// absent keep the defaults of Gripper, except `name`, `kind`, `max_opening_m`, `finger_depth_m`
/// and `palm_size_m`, which are required; with `finger_thickness_m` alone the tip is as thick.
/// `file` is its name in messages, which name members of the file. Throws InputError if the text is
/// not valid, has an unknown member, the gripper contradicts itself, or it is YAML and this build
/// has no yaml-cpp.
Gripper parse_gripper(std::string_view text, const std::string& file);
Gripper read_gripper(const std::filesystem::path& path);

/// The text that parse_gripper() reads. Throws InputError if a number is not finite.
std::string format_gripper(const Gripper& gripper);

}  // namespace symscene
