#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

#include "io/atomic_file.hpp"

namespace symscene::app {

/// Writes to standard output, through a pipe too at once. main() asks the stream for errors.
inline void print_output(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

/// Writes the file or, without one, to standard output.
inline void write_or_print(const std::filesystem::path& file, const std::string& text) {
  if (file.empty())
    print_output(text);
  else
    write_file_atomically(file, text);
}

}  // namespace symscene::app
