#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace symscene {

// Frames of LZ4 and Zstandard, where the build has these libraries; they throw InputError, with
// `name` as the file, where it has not.

/// Throw InputError unless the bytes are a whole frame that holds exactly `size` bytes.
std::string decompress_lz4(std::string_view bytes, std::size_t size, const std::string& name);
std::string decompress_zstd(std::string_view bytes, std::size_t size, const std::string& name);

std::string compress_lz4(std::string_view bytes);
std::string compress_zstd(std::string_view bytes);

/// Whether the bytes begin as a frame of Zstandard.
inline bool is_zstd(std::string_view bytes) { return bytes.starts_with("\x28\xb5\x2f\xfd"); }

/// Decompresses a frame that tells its size, of at most `largest` bytes.
std::string decompress_zstd_frame(std::string_view bytes, std::size_t largest,
                                  const std::string& name);

bool has_lz4();
bool has_zstd();

}  // namespace symscene
