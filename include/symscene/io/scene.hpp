#pragma once

#include <filesystem>
#include <string>

#include "symscene/core/scene.hpp"

namespace symscene {

/// A scene folder: cloud.ply or cloud.pcd; occupancy.bt and table_plane.txt if they are there, a
/// warning in the log if not.
/// Throws InputError if `dir` is no such folder or a file in it is not what it should be.
Scene read_scene(const std::filesystem::path& dir);

/// Writes a scene folder atomically: cloud.ply, scene.json, and as far as they are known
/// occupancy.bt, table_plane.txt and truth.json. `scene_json` is the text of scene.json
/// (parameters, times, version); the least there can be if empty.
/// Throws InputError if `dir` is not empty and not a scene folder that this function wrote, or
/// cannot be written; what was there is then as it was.
void write_scene(const std::filesystem::path& dir, const Scene& scene,
                 const std::string& scene_json = "", const SceneTruth* truth = nullptr);

}  // namespace symscene
