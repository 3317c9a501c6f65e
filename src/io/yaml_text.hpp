#pragma once

#include <string>

#include "io/json_cursor.hpp"

namespace symscene {

/// A document as YAML: maps and lists of them in blocks, other lists on one line. Numbers are ones
/// for YAML 1.1 too, whose readers take 1e-05 for text. Throws InputError if a string is not UTF-8.
std::string format_yaml(const Json& document);

}  // namespace symscene
