#pragma once

#include <cstdio>
#include <string>

namespace symscene::app {

/// Writes to standard output. Errors show when main() flushes the stream.
inline void print_output(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace symscene::app
