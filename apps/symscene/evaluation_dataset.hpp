#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "symscene/core/scene.hpp"

namespace symscene::app {

/// A scene and what is true of it.
struct KnownScene {
  Scene scene;
  SceneTruth truth;
};

/// A scene of a dataset, read when it is needed.
struct DatasetEntry {
  std::string name;
  std::string subset;  ///< may be empty
  std::function<KnownScene()> load;
};

/// The scenes of a folder, by name: every folder in it, or itself, that holds cloud.ply and
/// truth.json. Result folders (objects.json) are passed over. Throws InputError if there is no such
/// scene, or a scene without truth.
std::vector<DatasetEntry> read_dataset(const std::filesystem::path& folder);

}  // namespace symscene::app
