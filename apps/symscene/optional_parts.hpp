#pragma once

#include <string>
#include <vector>

namespace symscene::app {

/// A part of the build that needs libraries which may be missing, or that can be left out.
struct OptionalPart {
  std::string name;
  std::string needs;  ///< package or option of CMake that adds it
  bool is_in = false;
};

std::vector<OptionalPart> optional_parts();

/// What --version prints: the version, the optional parts of this build, and those that it lacks.
std::string version_text();

}  // namespace symscene::app
