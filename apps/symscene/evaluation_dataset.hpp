#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "symscene/core/scene.hpp"

namespace symscene::app {

/// A scene of a dataset on disk.
struct DatasetEntry {
  std::string name;
  std::string subset;  ///< what kind of scene; empty where not known
  std::filesystem::path folder;
};

struct DatasetListing {
  std::vector<DatasetEntry> entries;  ///< by name
  std::vector<std::string> missing;   ///< names of scenes that are not made yet
};

/// A scene with what is true of it.
struct LoadedEntry {
  Scene scene;
  SceneTruth truth;
  std::string subset;
  std::size_t objects = 0;  ///< that there are, whether or not enough of them is seen
};

/// The scenes of a folder: every folder in it, or itself, that holds cloud.ply. Result folders
/// (objects.json) are passed over. Throws InputError if there is none, or one without truth.
DatasetListing read_dataset(const std::filesystem::path& folder);

/// Throws InputError if a file cannot be read or truth names points that the cloud does not have.
LoadedEntry load_entry(const DatasetEntry& entry);

}  // namespace symscene::app
