#include "symscene/core/error.hpp"

#include <fmt/format.h>

namespace symscene {

InputError::InputError(std::string where, std::string expected, std::string found)
    : std::runtime_error(fmt::format("{}: expected {}, found {}", where, expected, found)),
      where_(std::move(where)),
      expected_(std::move(expected)),
      found_(std::move(found)) {}

void require_option(bool holds, const char* option, const char* expected, double found) {
  if (!holds) throw InputError(option, expected, fmt::format("{:g}", found));
}

}  // namespace symscene
