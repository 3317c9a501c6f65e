// A library to preload (Linux with glibc): makes one call of the C library fail, or only counts the
// calls.
//   SYMSCENE_FAULT="KIND N"      the N-th call of that kind fails; KIND is a name of `kinds`, or
//   kill: at the N-th call
//                                that changes files the process is killed; of what it writes, half
//                                is written before
//   SYMSCENE_FAULT_COUNTS=FILE   the counts, one std::uint64_t per kind; processes that are forked
//   share them
//   SYMSCENE_NO_EXCHANGE=1       no two files exchange their names, as on file systems that cannot
//                                do that: such calls fail and are not counted
// Calls count from the beginning to the end of main(). Files are those that the process opened
// itself: neither the standard streams nor sockets. Clocks stand still, so that equal runs write
// equal bytes, and nothing waits for a disk.
#undef _FORTIFY_SOURCE  // checked calls have other names
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdarg>
#include <cstdint>

#include "faults/fault_kinds.hpp"

extern "C" {
// Of glibc: the allocator below its names that may be replaced.
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* memory, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

using namespace symscene::testing;

using Counts = std::array<std::atomic<std::uint64_t>, kinds.size()>;

Counts own_counts;
Counts* counts = &own_counts;
std::atomic<bool> active{false};
std::size_t failing_kind = kinds.size();
std::uint64_t failing_call = 0;
bool can_exchange = true;

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// Counts a call; whether it is to fail.
bool counted(Kind kind) {
  if (!active.load(std::memory_order_relaxed)) return false;
  const auto index = static_cast<std::size_t>(kind);
  const std::uint64_t call = 1 + (*counts)[index].fetch_add(1);
  return index == failing_kind && call == failing_call;
}

[[noreturn]] void be_killed() {
  raise(SIGKILL);
  _exit(1);
}

/// Counts a call that changes files; whether it is to fail.
bool counted_change(Kind kind) {
  if (counted(Kind::kill)) be_killed();
  return counted(kind);
}

bool is_file(int file) {
  struct stat status {};
  return file > STDERR_FILENO && fstat(file, &status) == 0 && S_ISREG(status.st_mode);
}

bool is_written(int file) {
  return is_file(file) && (fcntl(file, F_GETFL) & O_ACCMODE) != O_RDONLY;
}

int failed(int error) {
  errno = error;
  return -1;
}

void* without_memory() {
  errno = ENOMEM;
  return nullptr;
}

/// A call that writes to `file`: write_share(n) writes an n-th of what was asked for.
template <class WriteShare>
ssize_t counted_write(int file, const WriteShare& write_share) {
  if (!active || !is_file(file)) return write_share(1);
  if (counted(Kind::kill)) {
    static_cast<void>(write_share(2) < 0);
    be_killed();
  }
  return counted(Kind::write) ? failed(ENOSPC) : write_share(1);
}

bool changes(int flags) { return (flags & (O_CREAT | O_TRUNC)) != 0; }

void begin() {
  if (const char* fault = getenv("SYMSCENE_FAULT")) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      const std::size_t length = strlen(kinds[i]);
      if (strncmp(fault, kinds[i], length) == 0 && fault[length] == ' ') failing_kind = i;
    }
    const char* number = strchr(fault, ' ');
    failing_call = number == nullptr ? 0 : strtoull(number, nullptr, 10);
  }
  can_exchange = getenv("SYMSCENE_NO_EXCHANGE") == nullptr;
  if (const char* path = getenv("SYMSCENE_FAULT_COUNTS")) {
    const int file = open(path, O_RDWR | O_CLOEXEC);
    void* shared = mmap(nullptr, sizeof(Counts), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (shared != MAP_FAILED) counts = static_cast<Counts*>(shared);
    close(file);
  }
  active = true;
}

using Main = int(int, char**, char**);
Main* program_main = nullptr;

int counted_main(int argc, char** argv, char** environment) {
  begin();
  const int code = program_main(argc, argv, environment);
  active = false;
  return code;
}

constexpr time_t now = 2'000'000'000;  ///< a day in 2033

}  // namespace

extern "C" {

int __libc_start_main(Main* main, int argc, char** argv, Main* init, void (*fini)(),
                      void (*rtld_fini)(), void* stack_end) {
  program_main = main;
  return real<int(Main*, int, char**, Main*, void (*)(), void (*)(), void*)>("__libc_start_main")(
      counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}

int clock_gettime(clockid_t, timespec* time) noexcept {
  *time = {now, 0};
  return 0;
}

int open(const char* path, int flags, ...) {
  mode_t mode = 0;
  if ((flags & O_CREAT) != 0) {
    va_list arguments;
    va_start(arguments, flags);
    mode = va_arg(arguments, mode_t);
    va_end(arguments);
  }
  if (changes(flags) ? counted_change(Kind::open) : counted(Kind::open)) return failed(EMFILE);
  return openat(AT_FDCWD, path, flags, mode);
}

int open64(const char* path, int flags, ...) __attribute__((alias("open")));

FILE* fopen(const char* path, const char* mode) {
  const bool written = strpbrk(mode, "wa+") != nullptr;
  if (written ? counted_change(Kind::open) : counted(Kind::open)) {
    errno = EMFILE;
    return nullptr;
  }
  static auto* const original = real<FILE*(const char*, const char*)>("fopen");
  return original(path, mode);
}

FILE* fopen64(const char* path, const char* mode) __attribute__((alias("fopen")));

int fclose(FILE* stream) {
  static auto* const original = real<int(FILE*)>("fclose");
  const bool fails = is_written(fileno(stream)) && counted_change(Kind::close);
  const int result = original(stream);
  return fails ? failed(EIO) : result;
}

ssize_t write(int file, const void* bytes, size_t size) {
  static auto* const original = real<ssize_t(int, const void*, size_t)>("write");
  return counted_write(file, [&](size_t n) { return original(file, bytes, size / n); });
}

ssize_t writev(int file, const iovec* parts, int count) {
  static auto* const original = real<ssize_t(int, const iovec*, int)>("writev");
  return counted_write(file, [&](int n) { return original(file, parts, count / n); });
}

ssize_t read(int file, void* bytes, size_t size) {
  static auto* const original = real<ssize_t(int, void*, size_t)>("read");
  if (active && is_file(file) && counted(Kind::read)) return failed(EIO);
  return original(file, bytes, size);
}

int fsync(int) { return counted_change(Kind::sync) ? failed(EIO) : 0; }

int rename(const char* from, const char* to) noexcept {
  static auto* const original = real<int(const char*, const char*)>("rename");
  return counted_change(Kind::rename) ? failed(EACCES) : original(from, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to,
              unsigned flags) noexcept {
  static auto* const original =
      real<int(int, const char*, int, const char*, unsigned)>("renameat2");
  if (!can_exchange && (flags & RENAME_EXCHANGE) != 0) return failed(EINVAL);
  if (counted_change(Kind::rename)) return failed(EINVAL);
  return original(from_folder, from, to_folder, to, flags);
}

int mkdir(const char* path, mode_t mode) noexcept {
  static auto* const original = real<int(const char*, mode_t)>("mkdir");
  return counted_change(Kind::mkdir) ? failed(EACCES) : original(path, mode);
}

void* malloc(size_t size) noexcept {
  return counted(Kind::allocation) ? without_memory() : __libc_malloc(size);
}

void* calloc(size_t count, size_t size) noexcept {
  return counted(Kind::allocation) ? without_memory() : __libc_calloc(count, size);
}

void* realloc(void* memory, size_t size) noexcept {
  return counted(Kind::allocation) ? without_memory() : __libc_realloc(memory, size);
}

void* aligned_alloc(size_t alignment, size_t size) noexcept {
  return counted(Kind::allocation) ? without_memory() : __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, size_t alignment, size_t size) noexcept {
  if (counted(Kind::allocation)) return ENOMEM;
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}

}  // extern "C"
