#include "symscene/io/scene.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/atomic_file.hpp"
#include "io/json_cursor.hpp"
#include "io/ply.hpp"
#include "octomap_log_odds.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/cloud.hpp"
#include "symscene/io/intrinsics.hpp"
#include "symscene/io/octomap.hpp"
#include "symscene/io/table_plane.hpp"
#include "symscene/io/trajectory.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

constexpr const char* scene_folder =
    "a scene folder, which holds cloud.ply (or cloud.pcd), occupancy.bt and table_plane.txt";

bool belongs_to_scene(const std::string& relative) {
  static constexpr std::array<std::string_view, 9> files = {
      "cloud.ply", "occupancy.bt",   "occupancy.ot", "table_plane.txt", "mesh.ply",
      "poses.txt", "intrinsics.txt", "scene.json",   "truth.json"};
  return std::find(files.begin(), files.end(), relative) != files.end();
}

fs::path find_cloud(const fs::path& dir) {
  if (!fs::exists(dir)) throw InputError(dir.string(), scene_folder, "nothing of that name");
  if (!fs::is_directory(dir)) throw InputError(dir.string(), scene_folder, "a file");
  const fs::path cloud = scene_cloud_file(dir);
  if (cloud.empty()) throw InputError(dir.string(), scene_folder, "a folder with no cloud.ply");
  return cloud;
}

/// The text of scene.json: the given one, checked, or a minimal one.
std::string scene_text(const std::string& scene_json) {
  if (scene_json.empty()) return "{\"version\": 1}\n";
  parse_json(scene_json, "scene.json to write");
  return scene_json;
}

}  // namespace

fs::path scene_cloud_file(const fs::path& dir) {
  for (const char* file : {"cloud.ply", "cloud.pcd"}) {
    if (fs::exists(dir / file)) return dir / file;
  }
  return {};
}

bool is_scene_folder(const fs::path& dir) { return !scene_cloud_file(dir).empty(); }

Scene read_scene(const fs::path& dir, const SceneReading& reading) {
  Scene scene;
  scene.cloud = read_cloud(find_cloud(dir));
  const fs::path occupancy = dir / "occupancy.bt";
  if (fs::exists(occupancy)) scene.occupancy = read_octomap(occupancy);
  const fs::path table = dir / "table_plane.txt";
  if (fs::exists(table)) scene.table = read_table_plane(table);
  if (!scene.table && reading.expects_table)
    scene.warnings.push_back(table.string() + " is missing: the table is not known");
  return scene;
}

void write_scene(const fs::path& dir, const Scene& scene, const SceneExtras& extras) {
  AtomicDirectory folder(dir, {"a scene folder", "scene.json", belongs_to_scene});
  folder.write("cloud.ply", format_ply(scene.cloud));
  if (scene.occupancy) folder.write("occupancy.bt", format_octomap(*scene.occupancy));
  if (scene.table) folder.write("table_plane.txt", format_table_plane(*scene.table));
  folder.write("scene.json", scene_text(extras.scene_json));
  if (!extras.truth_json.empty()) folder.write("truth.json", extras.truth_json);
  if (extras.mesh != nullptr) folder.write("mesh.ply", format_ply(*extras.mesh));
  if (extras.trajectory != nullptr)
    folder.write("poses.txt", format_trajectory(*extras.trajectory));
  if (extras.camera != nullptr) folder.write("intrinsics.txt", format_intrinsics(*extras.camera));
  if (extras.log_odds != nullptr) folder.write("occupancy.ot", format_log_odds(*extras.log_odds));
  folder.commit();
}

}  // namespace symscene
