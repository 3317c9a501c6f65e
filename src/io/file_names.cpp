#include "io/file_names.hpp"

namespace symscene {

bool is_yaml(const std::filesystem::path& path) {
  return path.extension() == ".yaml" || path.extension() == ".yml";
}

bool is_gripper_file(const std::filesystem::path& path) {
  return path.extension() == ".json" || is_yaml(path);
}

}  // namespace symscene
