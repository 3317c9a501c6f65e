#include "symscene/core/object_class.hpp"

#include <algorithm>
#include <array>

namespace symscene {
namespace {

constexpr std::array<const char*, 8> names = {"none",   "mirror",     "prism",    "box",
                                              "n_fold", "revolution", "cylinder", "sphere"};

}  // namespace

const char* to_string(SymmetryClass kind) { return names[static_cast<std::size_t>(kind)]; }

std::optional<SymmetryClass> symmetry_class_of(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<SymmetryClass>(found - names.begin());
}

}  // namespace symscene
