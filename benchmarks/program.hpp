#pragma once

#include <cstdio>
#include <exception>

namespace symscene::bench {

/// The exit code that run() gives; 1 with a line on standard error if it throws.
template <class Run>
int exit_code_of(const char* program, const Run& run) {
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", program, error.what());
    return 1;
  }
}

}  // namespace symscene::bench
