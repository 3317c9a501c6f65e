#include "made_by.hpp"

#include <algorithm>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/sha256.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Files of a sequence of one frame; a folder of more files holds other things too.
constexpr std::size_t most_files = 100;

/// Of a scene or a result: what segmentation reads. Surface and path are for display only.
std::vector<fs::path> files_of_scene(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const char* name :
       {"cloud.ply", "cloud.pcd", "occupancy.bt", "table_plane.txt", "objects.json"}) {
    if (fs::is_regular_file(folder / name)) files.emplace_back(name);
  }
  return files;
}

/// All files, but not those of scenes and results in the folder.
std::vector<fs::path> files_of_frame(const fs::path& folder) {
  std::vector<fs::path> files;
  for (auto entry = fs::recursive_directory_iterator(folder);
       entry != fs::recursive_directory_iterator() && files.size() < most_files; ++entry) {
    const fs::path& path = entry->path();
    if (entry->is_directory() &&
        (fs::exists(path / "scene.json") || fs::exists(path / "objects.json")))
      entry.disable_recursion_pending();
    else if (entry->is_regular_file())
      files.push_back(path.lexically_relative(folder));
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<fs::path> files_of(const fs::path& folder) {
  const bool is_scene = fs::exists(folder / "cloud.ply") || fs::exists(folder / "cloud.pcd");
  return is_scene ? files_of_scene(folder) : files_of_frame(folder);
}

Json hashed(const std::string& name, const fs::path& file) {
  return {{"file", name}, {"sha256", sha256_of_file(file)}};
}

}  // namespace

std::string made_by(const std::string& command, const fs::path& input, const std::string& options) {
  Json files = Json::array();
  if (fs::is_directory(input)) {
    for (const fs::path& file : files_of(input))
      files.push_back(hashed(file.generic_string(), input / file));
  } else {
    files.push_back(hashed(input.filename().string(), input));
  }
  const Json made = {{"symscene", SYMSCENE_VERSION},
                     {"command", command},
                     {"input", input.string()},
                     {"files", std::move(files)},
                     {"options", Json::parse(options)}};
  return made.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace symscene::app
