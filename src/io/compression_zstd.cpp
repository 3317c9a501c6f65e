#include "compression.hpp"
#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_ZSTD
#include <fmt/format.h>
#include <zstd.h>
#endif

namespace symscene {

#ifndef SYMSCENE_HAS_ZSTD

bool has_zstd() { return false; }

namespace {
[[noreturn]] void refuse_zstd(const std::string& name) {
  throw InputError(name, "a build with Zstandard (install libzstd-dev and build again)",
                   "one without");
}
}  // namespace

std::string decompress_zstd(std::string_view, std::size_t, const std::string& name) {
  refuse_zstd(name);
}
std::string decompress_zstd_frame(std::string_view, std::size_t, const std::string& name) {
  refuse_zstd(name);
}
std::string compress_zstd(std::string_view) { refuse_zstd("Zstandard"); }

#else

namespace {

/// Largest ratio of Zstandard: four bytes stand for a block of 128 KiB.
constexpr std::size_t most_zstd_inflation = 32768;
constexpr const char* a_zstd_frame = "a whole Zstandard frame";

}  // namespace

bool has_zstd() { return true; }

std::string decompress_zstd(std::string_view bytes, std::size_t size, const std::string& name) {
  if (size / most_zstd_inflation > bytes.size()) {
    throw InputError(name, a_zstd_frame, fmt::format("{} bytes for {}", bytes.size(), size));
  }
  std::string out(size, '\0');
  const std::size_t written = ZSTD_decompress(out.data(), size, bytes.data(), bytes.size());
  if (ZSTD_isError(written) != 0) {
    throw InputError(name, a_zstd_frame, ZSTD_getErrorName(written));
  }
  if (written != size) {
    throw InputError(name, a_zstd_frame, fmt::format("{} bytes in place of {}", written, size));
  }
  return out;
}

std::string decompress_zstd_frame(std::string_view bytes, std::size_t largest,
                                  const std::string& name) {
  const unsigned long long size = ZSTD_getFrameContentSize(bytes.data(), bytes.size());
  if (size == ZSTD_CONTENTSIZE_UNKNOWN || size == ZSTD_CONTENTSIZE_ERROR || size > largest) {
    throw InputError(name, fmt::format("a Zstandard frame of at most {} bytes", largest),
                     size > largest && size < ZSTD_CONTENTSIZE_ERROR
                         ? fmt::format("{}", size)
                         : std::string("one that does not tell its size"));
  }
  return decompress_zstd(bytes, size, name);
}

std::string compress_zstd(std::string_view bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 3));
  return out;
}

#endif

}  // namespace symscene
