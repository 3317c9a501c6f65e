#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace symscene::app {

/// Starts the dataset folder `dir`, or continues one that was made with the same options: its
/// dataset.json then equals `description`, except that the number of scenes may have grown.
/// Throws InputError if `dir` holds other files or a dataset with other options.
void begin_dataset_folder(const std::filesystem::path& dir,
                          const nlohmann::ordered_json& description);

/// The numbers of the scenes, of the first `scenes`, that are not complete on disk.
std::vector<std::size_t> missing_scenes(const std::filesystem::path& dir, std::size_t scenes);

}  // namespace symscene::app
