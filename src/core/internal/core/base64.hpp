#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace symscene {

/// Appends an integer in little endian order.
template <class Integer>
void append_little_endian(std::vector<std::uint8_t>& bytes, Integer value) {
  const auto bits = static_cast<std::make_unsigned_t<Integer>>(value);
  for (std::size_t k = 0; k < sizeof(Integer); ++k) {
    bytes.push_back(static_cast<std::uint8_t>((bits >> (8 * k)) & 0xFF));
  }
}

/// RFC 4648, section 4.
inline std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  char* out = text.data();
  for (std::size_t i = 0; i < bytes.size(); i += 3, out += 4) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < count; ++k) group |= std::uint32_t{bytes[i + k]} << (16 - 8 * k);
    for (std::size_t k = 0; k <= count; ++k) out[k] = alphabet[(group >> (18 - 6 * k)) & 63];
  }
  return text;
}

}  // namespace symscene
