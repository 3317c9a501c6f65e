#pragma once

#include "io/json_cursor.hpp"

namespace symscene {

/// A YAML document as JSON: a plain scalar is a number, true, false or null where it reads as one,
/// and text otherwise. Throws InputError if the text is not YAML, a key occurs twice, aliases make
/// it very deep or large, or this build has no yaml-cpp.
Json parse_yaml(std::string_view text, const std::string& name);

}  // namespace symscene
