#include "symscene/io/tree_model.hpp"

#include "io/atomic_file.hpp"

namespace symscene {

TreeModel read_tree_model(const std::filesystem::path& path) {
  return parse_tree_model(read_file(path), path.string());
}

}  // namespace symscene
