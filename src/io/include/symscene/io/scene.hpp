#pragma once

#include <filesystem>
#include <string>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

/// A scene folder: cloud.ply or cloud.pcd; occupancy.bt and table_plane.txt if they are there, and
/// Scene::warnings if not.
/// Throws InputError if `dir` is no such folder or a file in it is not what it should be.
Scene read_scene(const std::filesystem::path& dir);

/// What stands in a scene folder beside the scene, as far as it is there.
struct SceneExtras {
  std::string scene_json = {};             ///< the text of scene.json: parameters, times, version
  const SceneTruth* truth = nullptr;       ///< truth.json
  const TriangleMesh* mesh = nullptr;      ///< mesh.ply
  const Trajectory* trajectory = nullptr;  ///< poses.txt
  const LogOddsMap* log_odds = nullptr;    ///< occupancy.ot
};

/// Writes a scene folder atomically: cloud.ply, scene.json (the least there can be if none is
/// given), occupancy.bt and table_plane.txt as far as they are known, and the extras.
/// Throws InputError if `dir` is not empty and not a scene folder that this function wrote, or
/// cannot be written; what was there is then as it was.
void write_scene(const std::filesystem::path& dir, const Scene& scene,
                 const SceneExtras& extras = {});

}  // namespace symscene
