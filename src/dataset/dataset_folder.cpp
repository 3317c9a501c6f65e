#include "symscene/dataset/dataset_folder.hpp"

#include <fmt/format.h>

namespace symscene {

std::filesystem::path scene_folder(const std::filesystem::path& dataset, std::size_t index) {
  return dataset / "scenes" / fmt::format("{:04}", index);
}

}  // namespace symscene
