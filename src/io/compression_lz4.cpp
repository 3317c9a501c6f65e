#include "compression.hpp"
#include "symscene/core/error.hpp"

#ifdef SYMSCENE_HAS_LZ4
#include <memory>

#include <fmt/format.h>
#include <lz4frame.h>
#endif

namespace symscene {

#ifndef SYMSCENE_HAS_LZ4

bool has_lz4() { return false; }

namespace {
[[noreturn]] void refuse_lz4(const std::string& name) {
  throw InputError(name, "a build with LZ4 (install liblz4-dev and build again)", "one without");
}
}  // namespace

std::string decompress_lz4(std::string_view, std::size_t, const std::string& name) {
  refuse_lz4(name);
}
std::string compress_lz4(std::string_view) { refuse_lz4("LZ4"); }

#else

namespace {

/// Largest ratio of LZ4: a byte of length stands for 255.
constexpr std::size_t most_lz4_inflation = 255;
constexpr const char* an_lz4_frame = "a whole LZ4 frame";

}  // namespace

bool has_lz4() { return true; }

std::string decompress_lz4(std::string_view bytes, std::size_t size, const std::string& name) {
  if (size / most_lz4_inflation > bytes.size()) {
    throw InputError(name, an_lz4_frame, fmt::format("{} bytes for {}", bytes.size(), size));
  }
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) {
    throw std::bad_alloc();
  }
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      made, LZ4F_freeDecompressionContext);
  std::string out(size, '\0');
  std::size_t written = 0;
  std::size_t hint = 1;  // 0 at the end of the frame
  while (hint != 0) {
    std::size_t produced = size - written;
    std::size_t consumed = bytes.size();
    hint = LZ4F_decompress(context.get(), out.data() + written, &produced, bytes.data(), &consumed,
                           nullptr);
    if (LZ4F_isError(hint) != 0) throw InputError(name, an_lz4_frame, LZ4F_getErrorName(hint));
    if (hint != 0 && produced == 0 && consumed == 0) {
      throw InputError(name, an_lz4_frame, "one of another size");
    }
    written += produced;
    bytes.remove_prefix(consumed);
  }
  if (written != size || !bytes.empty()) {
    throw InputError(name, an_lz4_frame, fmt::format("{} bytes in place of {}", written, size));
  }
  return out;
}

std::string compress_lz4(std::string_view bytes) {
  std::string out(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  out.resize(LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr));
  return out;
}

#endif

}  // namespace symscene
