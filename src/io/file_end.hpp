#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "text.hpp"

namespace symscene {

/// Throws InputError if more than padding (zeros, white space) is left of a file whose content has
/// been read.
inline void require_end(std::string_view rest, const std::string& name) {
  const auto is_padding = [](char c) { return c == '\0' || is_space(c); };
  if (std::all_of(rest.begin(), rest.end(), is_padding)) return;
  throw InputError(name, "the end of the file", fmt::format("{} bytes more", rest.size()));
}

}  // namespace symscene
