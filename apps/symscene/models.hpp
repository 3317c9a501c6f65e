#pragma once

#include <filesystem>
#include <string>

namespace symscene::app {

/// The extension of a file in lower case: ".ply".
std::string lower_extension(const std::filesystem::path& path);

/// Whether a file is a cloud rather than a mesh; a PLY file can be either.
bool is_cloud_file(const std::filesystem::path& path);

}  // namespace symscene::app
