#pragma once

#include <cstdio>
#include <string>

namespace symscene::app {

/// To standard output. Whether it arrived shows when the stream is flushed at the end.
inline void print_output(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace symscene::app
