#pragma once

#include <filesystem>
#include <vector>

#include "symscene/simulation/object_model.hpp"

namespace symscene {

/// Whether every turn about its centre leaves a surface in place, by the bound up to which
/// symmetries of scanned meshes are strict: a mean distance of 0.008 of its diagonal. A search
/// along some directions may list one axis of such a ball, or two.
bool is_ball(const TriangleMesh& mesh);

/// The meshes in a folder (in metres), named for their files and sorted by name, with what a file
/// of symmetries says of them; no file where its path is empty. What it names and is_ball() knows
/// is a sphere whatever it says. Throws InputError if the folder holds no mesh, or a file in it or
/// that of the symmetries cannot be read.
std::vector<ObjectModel> read_models(const std::filesystem::path& meshes,
                                     const std::filesystem::path& symmetries);

}  // namespace symscene
