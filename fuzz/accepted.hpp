#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "symscene/core/error.hpp"

namespace symscene::fuzz {

inline std::string_view as_bytes(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The result of `parse`, or nothing if it refuses its input with an InputError. Any other
/// exception is a finding.
template <class Parse>
auto accepted(const Parse& parse) -> std::optional<decltype(parse())> {
  try {
    return parse();
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace symscene::fuzz
