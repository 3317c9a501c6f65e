#include "evaluation_dataset.hpp"

#include <algorithm>

#include "arguments.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/scene.hpp"
#include "symscene/io/truth.hpp"

namespace symscene::app {
namespace fs = std::filesystem;

namespace {

bool is_scene(const fs::path& folder) {
  const bool has_cloud = fs::exists(folder / "cloud.ply") || fs::exists(folder / "cloud.pcd");
  return has_cloud && !fs::exists(folder / "objects.json");
}

/// "a/0001" of "data/a/0001/scene".
std::string entry_name(const fs::path& scene, const fs::path& dataset) {
  if (scene == dataset) return folder_name(dataset);
  fs::path name = scene.lexically_relative(dataset);
  if (name.filename() == "scene" && name.has_parent_path()) name = name.parent_path();
  return name.generic_string();
}

}  // namespace

DatasetListing read_dataset(const fs::path& folder) {
  const char* expected = "a folder of scene folders, each with truth.json";
  if (!fs::is_directory(folder)) {
    throw InputError(folder.string(), expected,
                     fs::exists(folder) ? "a file" : "nothing of that name");
  }
  std::vector<fs::path> scenes;
  if (is_scene(folder)) scenes.push_back(folder);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_directory() && is_scene(entry.path())) scenes.push_back(entry.path());
  }
  if (scenes.empty()) throw InputError(folder.string(), expected, "no scene");
  std::sort(scenes.begin(), scenes.end());
  DatasetListing listing;
  for (const fs::path& scene : scenes) {
    if (!fs::exists(scene / "truth.json"))
      throw InputError(scene.string(), "truth.json beside the cloud", "a scene without truth");
    listing.entries.push_back({entry_name(scene, folder), "", scene});
  }
  return listing;
}

LoadedEntry load_entry(const DatasetEntry& entry) {
  LoadedEntry loaded;
  loaded.scene = read_scene(entry.folder);
  loaded.truth = read_truth(entry.folder / "truth.json", loaded.scene.cloud.size());
  loaded.subset = entry.subset;
  loaded.objects = loaded.truth.objects.size();
  return loaded;
}

}  // namespace symscene::app
