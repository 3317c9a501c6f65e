#include "temporary_name.hpp"

#include <unistd.h>

#include <atomic>

#include <fmt/format.h>

namespace symscene {

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  static std::atomic<unsigned> counter{0};
  std::filesystem::path beside = path;
  beside.replace_filename(
      fmt::format(".{}.tmp-{}-{}", path.filename().string(), getpid(), counter++));
  return beside;
}

}  // namespace symscene
