#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "symscene/core/triangle_mesh.hpp"
#include "symscene/ground_truth/scene_truth.hpp"

namespace symscene {

/// Parses the ground truth of a scene from truth.json (docs/formats.md). An object without points
/// must name a mesh and its pose; its points are then empty and its name is that of the mesh.
/// Normals and directions are scaled to unit length. `name` is the name of the file in messages.
/// Throws InputError if the text is not a valid truth.json, or `cloud_size` is given and an index
/// is not below it.
SceneTruth parse_truth(std::string_view text, const std::string& name,
                       std::optional<Index> cloud_size = std::nullopt);
SceneTruth read_truth(const std::filesystem::path& path,
                      std::optional<Index> cloud_size = std::nullopt);

/// Reads the mesh of every object from `dir`/meshes (docs/formats.md).
/// Throws InputError if an object names no mesh or its file does not exist.
std::vector<TriangleMesh> read_truth_meshes(const std::filesystem::path& dir,
                                            const SceneTruth& truth);

/// Reads the symmetries of models, each in the frame of the model, by name (docs/formats.md).
/// Throws InputError if the file is not valid.
std::vector<TrueObject> read_model_symmetries(const std::filesystem::path& path);

/// The text of truth.json. Throws InputError if a number is not finite.
std::string format_truth(const SceneTruth& truth);

}  // namespace symscene
