#pragma once

#include <filesystem>
#include <vector>

#include "symscene/simulation/object_model.hpp"

namespace symscene {

/// The meshes in a folder (in metres), named for their files and sorted by name, with what a file
/// of symmetries says of them; no file where its path is empty. Throws InputError if the folder
/// holds no mesh, or a file in it or that of the symmetries cannot be read.
std::vector<ObjectModel> read_models(const std::filesystem::path& meshes,
                                     const std::filesystem::path& symmetries);

}  // namespace symscene
