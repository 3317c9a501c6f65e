#include "io/atomic_file.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "symscene/core/error.hpp"
#include "temporary_name.hpp"

namespace symscene {
namespace {

namespace fs = std::filesystem;

std::string last_error() { return std::generic_category().message(errno == 0 ? EIO : errno); }

void require_readable(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw InputError(path.string(), "a file", "nothing of that name");
  }
  if (fs::is_directory(status)) throw InputError(path.string(), "a file", "a folder");
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

std::string read_file(const fs::path& path) {
  require_readable(path);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path.string(), "a file that can be read", last_error());
  std::string bytes;
  std::error_code unknown_size;
  const auto size = fs::file_size(path, unknown_size);
  std::size_t chunk = unknown_size ? 65536 : static_cast<std::size_t>(size) + 1;
  for (; stream; chunk = 65536) {
    const std::size_t begin = bytes.size();
    bytes.resize(begin + chunk);
    stream.read(bytes.data() + begin, static_cast<std::streamsize>(chunk));
    bytes.resize(begin + static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) throw InputError(path.string(), "a file that can be read", last_error());
  return bytes;
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
  const fs::path temporary = temporary_beside(path);
  std::error_code error;
  try {
    write_bytes(temporary, bytes, path);
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
