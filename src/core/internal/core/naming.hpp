#pragma once

#include <filesystem>

#include "symscene/core/error.hpp"

namespace symscene {

/// Runs `work`. An InputError from it names `path` too.
template <class Work>
auto naming(const std::filesystem::path& path, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.where(), error.expected(), error.found());
  }
}

}  // namespace symscene
