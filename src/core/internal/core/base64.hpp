#pragma once

#include <cstdint>
#include <span>
#include <string>
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
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace symscene
