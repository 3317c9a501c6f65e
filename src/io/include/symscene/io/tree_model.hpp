#pragma once

#include <filesystem>

#include "symscene/core/tree_model.hpp"

namespace symscene {

/// parse_tree_model() of a file. Throws InputError, also if the file cannot be read.
TreeModel read_tree_model(const std::filesystem::path& path);

}  // namespace symscene
