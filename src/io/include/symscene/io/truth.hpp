#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// What is known of a scene, from the text of its truth.json (docs/formats.md). An object without
/// points must name a mesh and its pose; its points are then empty and its name is the mesh's.
/// Normals and directions are scaled to unit length. `name` stands for the file in messages.
/// Throws InputError if the text is no such file, or an index is not below `cloud_size` where that
/// is given.
SceneTruth parse_truth(std::string_view text, const std::string& name,
                       std::optional<Index> cloud_size = std::nullopt);
SceneTruth read_truth(const std::filesystem::path& path,
                      std::optional<Index> cloud_size = std::nullopt);

/// The meshes of a truth's objects, one each, from the folder "meshes" beside it (docs/formats.md).
/// Throws InputError if an object names no mesh or its file is not there.
std::vector<TriangleMesh> read_truth_meshes(const std::filesystem::path& dir,
                                            const SceneTruth& truth);

/// Symmetries of models by name, each in the model's own frame (docs/formats.md).
/// Throws InputError if the file is no such file.
std::vector<TrueObject> read_model_symmetries(const std::filesystem::path& path);

/// The text of truth.json. Throws InputError if a number is not finite.
std::string format_truth(const SceneTruth& truth);

/// Writes format_truth() atomically.
void write_truth(const std::filesystem::path& path, const SceneTruth& truth);

}  // namespace symscene
