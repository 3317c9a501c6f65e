#include "made_by.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "arguments.hpp"
#include "io/sha256.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/scene.hpp"

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

/// Whether readers of sequences open files of that name: images, lists, poses and cameras.
bool is_read_of_sequence(const fs::path& file) {
  static constexpr std::array<std::string_view, 7> endings = {".png",  ".jpg", ".jpeg",    ".txt",
                                                              ".json", ".log", ".freiburg"};
  return std::find(endings.begin(), endings.end(), file.extension().string()) != endings.end();
}

/// What readers of sequences open, but not the files of scenes, results and masks in the folder.
/// Folders that cannot be read are left out.
std::vector<fs::path> files_of_frame(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         error);
  for (; entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    if (is_output_folder(path))
      entry.disable_recursion_pending();
    else if (is_read_of_sequence(path) && entry->is_regular_file(error))
      files.push_back(path.lexically_relative(folder));
  }
  std::sort(files.begin(), files.end());
  files.resize(std::min(files.size(), most_files));
  return files;
}

std::vector<fs::path> files_of(const fs::path& folder) {
  return is_scene_folder(folder) ? files_of_scene(folder) : files_of_frame(folder);
}

/// Adds the hash of a file.
void add_hash(Json& files, const std::string& name, const fs::path& file, Session& session) {
  try {
    files.push_back({{"file", name}, {"sha256", sha256_of_file(file)}});
  } catch (const InputError& error) {
    session.warn(fmt::format("{}; made_by leaves it out", error.what()));
  }
}

}  // namespace

std::string made_by(const std::string& command, const fs::path& input, const std::string& options,
                    Session& session) {
  Json files = Json::array();
  if (fs::is_directory(input)) {
    for (const fs::path& file : files_of(input))
      add_hash(files, file.generic_string(), input / file, session);
  } else {
    add_hash(files, input.filename().string(), input, session);
  }
  const Json made = {{"symscene", SYMSCENE_VERSION},
                     {"command", command},
                     {"input", input.string()},
                     {"files", std::move(files)},
                     {"options", Json::parse(options)}};
  return made.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace symscene::app
