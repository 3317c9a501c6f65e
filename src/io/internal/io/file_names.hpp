#pragma once

#include <filesystem>

namespace symscene {

/// Whether a name ends in .yaml or .yml.
bool is_yaml(const std::filesystem::path& path);

/// Whether a name is that of a file that describes a gripper, by its end: .json, .yaml or .yml.
bool is_gripper_file(const std::filesystem::path& path);

}  // namespace symscene
