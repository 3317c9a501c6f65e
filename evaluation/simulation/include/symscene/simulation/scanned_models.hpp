#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "symscene/simulation/object_model.hpp"

namespace symscene {

/// Whether a surface is that of a ball: every rotation about its centre maps it onto itself within
/// the bound of strict symmetries of scanned meshes, a mean distance of 0.008 of the diagonal. A
/// symmetry search over some directions may list a single axis of such a mesh, or two.
bool is_ball(const TriangleMesh& mesh);

/// The models of a folder of meshes.
struct ModelFolder {
  std::vector<ObjectModel> models;    ///< by name
  std::vector<std::string> warnings;  ///< one sentence per file that was not used
};

/// Reads the meshes in a folder (in metres), named for their files and sorted by name, with their
/// symmetries from the file `symmetries`, if its path is not empty. A mesh named there that
/// is_ball() accepts is a sphere, whatever symmetries the file lists. Throws InputError if the
/// folder has no mesh, or a file of symmetries cannot be read.
ModelFolder read_models(const std::filesystem::path& meshes,
                        const std::filesystem::path& symmetries);

}  // namespace symscene
