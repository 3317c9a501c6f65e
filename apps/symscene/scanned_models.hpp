#pragma once

#include <filesystem>
#include <vector>

#include "symscene/simulation/object_model.hpp"

namespace symscene::app {

/// The meshes in a folder, named for their files, with what a file of symmetries says of them; no
/// file where its path is empty.
std::vector<ObjectModel> read_models(const std::filesystem::path& meshes,
                                     const std::filesystem::path& symmetries);

}  // namespace symscene::app
