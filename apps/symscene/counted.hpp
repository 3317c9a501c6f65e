#pragma once

#include <string>

#include <fmt/format.h>

namespace symscene::app {

/// "1 frame", "2 frames": a number with its noun, whose plural ends in s.
inline std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace symscene::app
