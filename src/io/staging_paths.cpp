#include "io/staging_paths.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "symscene/io/staging.hpp"
#include "temporary_name.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

/// Signal handlers can neither allocate nor lock: a fixed number of paths in place.
struct Slot {
  std::atomic<pid_t> owner{0};  ///< 0: unused; set after the path
  std::atomic<bool> taken{false};
  std::array<char, PATH_MAX> path{};
};
std::array<Slot, 64> slots;
constexpr std::size_t no_slot = slots.size();

/// As the kernel fills it in: getdents64(2). readdir() is not safe in signal handlers.
struct KernelEntry {
  std::uint64_t inode;
  std::int64_t offset;
  std::uint16_t length;
  std::uint8_t type;
  char name[1];
};

bool is_self_or_parent(const char* name) {
  return name[0] == '.' && (name[1] == '\0' || (name[1] == '.' && name[2] == '\0'));
}

/// Removes a file or a folder with all in it, by calls that are safe in signal handlers.
void remove_in_signal(int folder, const char* name, int depth) {
  constexpr int deepest = 16;
  if (unlinkat(folder, name, 0) == 0 || (errno != EISDIR && errno != EPERM) || depth > deepest)
    return;
  const int inner = openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (inner < 0) return;
  alignas(KernelEntry) char buffer[4096];
  for (long size; (size = syscall(SYS_getdents64, inner, buffer, sizeof buffer)) > 0;) {
    for (long at = 0; at < size;) {
      const auto* entry = reinterpret_cast<const KernelEntry*>(buffer + at);
      if (!is_self_or_parent(entry->name)) remove_in_signal(inner, entry->name, depth + 1);
      at += entry->length;
    }
  }
  close(inner);
  unlinkat(folder, name, AT_REMOVEDIR);
}

void remove_and_end(int signal) {
  const pid_t self = getpid();
  for (const Slot& slot : slots) {
    if (slot.owner.load() == self) remove_in_signal(AT_FDCWD, slot.path.data(), 0);
  }
  ::signal(signal, SIG_DFL);
  raise(signal);
}

std::size_t take_slot(const std::string& path) {
  if (path.size() >= PATH_MAX) return no_slot;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].taken.exchange(true)) continue;
    std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
    slots[i].owner = getpid();
    return i;
  }
  return no_slot;
}

}  // namespace

StagingPath::StagingPath(const fs::path& path) : slot_(take_slot(path.string())) {}

StagingPath::~StagingPath() {
  if (slot_ == no_slot) return;
  slots[slot_].owner = 0;
  slots[slot_].taken = false;
}

void remove_stale_staging(const fs::path& path) {
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::vector<fs::path> stale;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
    const auto process = writer_of(entry->path().filename().string(), path.filename().string());
    if (process && kill(*process, 0) != 0 && errno == ESRCH) stale.push_back(entry->path());
  }
  for (const fs::path& left : stale) {
    if (is_set_aside(left.filename().string()) && !fs::exists(fs::symlink_status(path, ignored)))
      fs::rename(left, path, ignored);
    else
      fs::remove_all(left, ignored);
  }
}

void remove_staging_on_signals() {
  struct sigaction action {};
  action.sa_handler = remove_and_end;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    // What the caller ignores, as nohup does, stays ignored.
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
  }
  ::signal(SIGXFSZ, SIG_IGN);  // to write beyond the limit of a file's size is an error instead
}

}  // namespace symscene
