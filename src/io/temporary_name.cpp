#include "temporary_name.hpp"

#include <unistd.h>

#include <atomic>
#include <fstream>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "text.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

/// Of the running system and its name space of processes.
const std::string& host() {
  static const std::string name = [] {
    std::string boot;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;
    std::error_code ignored;
    const std::string space = fs::read_symlink("/proc/self/ns/pid", ignored).string();
    return fmt::format("{:08x}",
                       static_cast<std::uint32_t>(std::hash<std::string>{}(boot + space)));
  }();
  return name;
}

constexpr std::string_view set_aside = ".old";

std::string beginning(std::string_view target) {
  return fmt::format(".{}.tmp-{}-", target, host());
}

}  // namespace

fs::path temporary_beside(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  fs::path beside = path;
  beside.replace_filename(
      fmt::format("{}{}-{}", beginning(path.filename().string()), getpid(), counter++));
  return beside;
}

fs::path set_aside_beside(const fs::path& path) { return temporary_beside(path) += set_aside; }

bool is_set_aside(std::string_view name) { return name.ends_with(set_aside); }

std::optional<pid_t> writer_of(std::string_view name, std::string_view target) {
  const std::string begin = beginning(target);
  if (!name.starts_with(begin)) return std::nullopt;
  name.remove_prefix(begin.size());
  const auto process = to_number<pid_t>(name.substr(0, name.find('-')));
  return process && *process > 0 ? process : std::nullopt;
}

}  // namespace symscene
