#pragma once

#include <filesystem>

namespace symscene {

/// What every dataset folder that SymScene makes holds (docs/formats.md).
inline constexpr const char* dataset_file = "dataset.json";

/// Where scene `index` of a dataset lies.
std::filesystem::path scene_folder(const std::filesystem::path& dataset, std::size_t index);

}  // namespace symscene
