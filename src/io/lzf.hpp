#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace symscene {

/// Largest ratio of decompressed to compressed size: three bytes encode at most 264.
constexpr std::size_t lzf_largest_growth = 88;

/// Decompresses an LZF stream of `size` bytes; returns nothing if it is not such a stream.
std::optional<std::string> decompress_lzf(std::string_view stream, std::size_t size);

}  // namespace symscene
