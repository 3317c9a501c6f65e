#pragma once

#include <filesystem>
#include <string>

#include "symscene/core/depth_frame.hpp"
#include "symscene/core/scene.hpp"
#include "symscene/core/triangle_mesh.hpp"

namespace symscene {

struct SceneReading {
  bool expects_table = true;  ///< warn if the folder has no table
};

/// The file of a scene folder's cloud, cloud.ply or cloud.pcd; empty if the folder has none.
std::filesystem::path scene_cloud_file(const std::filesystem::path& dir);
/// Whether it has one.
bool is_scene_folder(const std::filesystem::path& dir);

/// Reads a scene folder: cloud.ply or cloud.pcd, and occupancy.bt and table_plane.txt if they
/// exist; Scene::warnings names those that are missing. Throws InputError if `dir` is not a scene
/// folder or a file is not valid.
Scene read_scene(const std::filesystem::path& dir, const SceneReading& reading = {});

/// Optional files of a scene folder.
struct SceneExtras {
  std::string scene_json = {};               ///< text of scene.json: parameters, times, version
  std::string truth_json = {};               ///< text of truth.json, where there is ground truth
  const TriangleMesh* mesh = nullptr;        ///< mesh.ply
  const Trajectory* trajectory = nullptr;    ///< poses.txt
  const CameraIntrinsics* camera = nullptr;  ///< intrinsics.txt, of the frames at these poses
  const LogOddsMap* log_odds = nullptr;      ///< occupancy.ot
};

/// Writes a scene folder atomically: cloud.ply, scene.json (a minimal one if none is given),
/// occupancy.bt and table_plane.txt if they are known, and the extras.
/// Throws InputError if `dir` is neither empty nor a scene folder that this function wrote, or
/// cannot be written; an existing folder is then unchanged.
void write_scene(const std::filesystem::path& dir, const Scene& scene,
                 const SceneExtras& extras = {});

}  // namespace symscene
