#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include <fmt/format.h>

#include "symscene/core/error.hpp"
#include "temporary_name.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

std::string last_error() { return std::generic_category().message(errno == 0 ? EIO : errno); }

const char* kind_of(fs::file_type type) {
  switch (type) {
    case fs::file_type::not_found:
      return "nothing of that name";
    case fs::file_type::directory:
      return "a folder";
    case fs::file_type::fifo:
      return "a pipe";
    case fs::file_type::socket:
      return "a socket";
    default:
      return "a device";
  }
}

/// Reads to the end: a file may grow or shrink while it is read.
std::string read_stream(std::istream& stream, std::size_t expected, std::uintmax_t largest) {
  std::string bytes;
  for (std::size_t chunk = expected + 1; stream && bytes.size() <= largest; chunk = 65536) {
    const std::size_t begin = bytes.size();
    bytes.resize(begin + chunk);
    stream.read(bytes.data() + begin, static_cast<std::streamsize>(chunk));
    bytes.resize(begin + static_cast<std::size_t>(stream.gcount()));
  }
  return bytes;
}

void require_size(const fs::path& path, std::uintmax_t size, std::uintmax_t largest) {
  if (size <= largest) return;
  throw InputError(path.string(), fmt::format("a file of at most {} MB", largest / 1'000'000),
                   fmt::format("{} MB", size / 1'000'000));
}

void write_bytes(const fs::path& path, std::string_view bytes, const fs::path& shown) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  if (stream) {
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    stream.close();
  }
  if (!stream) throw InputError(shown.string(), "a place that can be written", last_error());
}

}  // namespace

void require_regular_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!error && fs::is_regular_file(status)) return;
  if (error && status.type() != fs::file_type::not_found)
    throw InputError(path.string(), "a file that can be read", error.message());
  throw InputError(path.string(), "a file", kind_of(status.type()));
}

void sync_to_disk(const fs::path& path, const fs::path& shown) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = file >= 0 && fsync(file) == 0;
  const int error = errno;
  if (file >= 0) close(file);
  // Some file systems cannot: then the rename is as safe as they are.
  if (synced || error == EINVAL || error == ENOTSUP || error == EROFS) return;
  throw InputError(shown.string(), "a place that can be written",
                   std::generic_category().message(error));
}

std::string read_file(const fs::path& path, std::uintmax_t largest) {
  require_regular_file(path);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string(), "a file that can be read", last_error());
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(path, unknown);
  if (!unknown) require_size(path, size, largest);
  std::string bytes =
      read_stream(stream, unknown ? 65535 : static_cast<std::size_t>(size), largest);
  require_size(path, bytes.size(), largest);
  if (stream.bad()) throw InputError(path.string(), "a file that can be read", last_error());
  return bytes;
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
  remove_stale_staging(path);
  const fs::path temporary = temporary_beside(path);
  const StagingPath on_signal(temporary);
  std::error_code error;
  try {
    write_bytes(temporary, bytes, path);
    sync_to_disk(temporary, path);
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
  fs::rename(temporary, path, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  throw InputError(path.string(), "a file that can be replaced", error.message());
}

}  // namespace symscene
