#include "dataset_resume.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "io/atomic_file.hpp"
#include "io/json_cursor.hpp"
#include "symscene/core/error.hpp"
#include "symscene/dataset/dataset_folder.hpp"

namespace symscene::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A scene that lacks one of these is made again.
constexpr std::array scene_files{"scene.json", "cloud.ply", "truth.json"};

/// The first option that differs between two descriptions of datasets, with both values.
std::string first_difference(const Json& wanted, const Json& found) {
  const Json a = wanted.flatten();
  const Json b = found.flatten();
  for (const auto& [key, value] : a.items()) {
    const std::string was = b.contains(key) ? b[key].dump() : "nothing";
    if (was != value.dump())
      return fmt::format("{} {} in place of {}", key.substr(1), was, value.dump());
  }
  for (const auto& [key, value] : b.items()) {
    if (!a.contains(key)) return fmt::format("{} {}", key.substr(1), value.dump());
  }
  return "";
}

/// Raises the number of scenes in a description to that of `wanted`: a scene does not depend on how
/// many others there are. Returns whether it was raised.
bool raise_scene_count(Json& description, const Json& wanted) {
  const Json::json_pointer place("/options/scenes");
  if (!description.contains(place) || !description[place].is_number_integer()) return false;
  if (description[place].get<long long>() >= wanted[place].get<long long>()) return false;
  description[place] = wanted[place];
  return true;
}

void create_folder(const fs::path& dir) {
  if (fs::exists(dir) && (!fs::is_directory(dir) || !fs::is_empty(dir)))
    throw InputError(dir.string(), "a new or an empty folder, or a dataset to continue",
                     fs::is_directory(dir) ? "a folder with other files" : "a file");
  fs::create_directories(dir);
}

bool is_complete(const fs::path& scene) {
  return std::all_of(scene_files.begin(), scene_files.end(),
                     [&](const char* file) { return fs::exists(scene / file); });
}

}  // namespace

void begin_dataset_folder(const fs::path& dir, const Json& description) {
  const fs::path file = dir / dataset_file;
  if (!fs::exists(file)) {
    // Of a run that was killed before it had written the first file.
    remove_stale_staging(file);
    create_folder(dir);
    write_file_atomically(file, description.dump(2) + "\n");
    return;
  }
  Json found = parse_json(read_file(file), file.string());
  // Datasets of earlier versions name the splits "tune" and "report".
  if (found.contains("split") && found["split"].is_string())
    found["split"] = to_string(parse_split(found["split"].get<std::string>(), file.string()));
  const bool grows = raise_scene_count(found, description);
  const std::string difference = first_difference(description, found);
  if (!difference.empty())
    throw InputError(file.string(), "a dataset made with the same options", difference);
  if (grows) write_file_atomically(file, description.dump(2) + "\n");
}

std::vector<std::size_t> missing_scenes(const fs::path& dir, std::size_t scenes) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < scenes; ++i) {
    if (!is_complete(scene_folder(dir, i))) indices.push_back(i);
  }
  return indices;
}

}  // namespace symscene::app
