#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace symscene {

/// An LZF stream never grows by more than this factor: three bytes stand for at most 264.
constexpr std::size_t lzf_largest_growth = 88;

/// The `size` bytes that an LZF stream stands for; nothing if it is not such a stream.
std::optional<std::string> decompress_lzf(std::string_view stream, std::size_t size);

}  // namespace symscene
