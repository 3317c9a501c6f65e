#pragma once

#include <cstdint>
#include <type_traits>

namespace symscene {

/// Appends an integer in little endian order to a string or a vector of bytes.
template <class Bytes, class Integer>
void append_little_endian(Bytes& bytes, Integer value) {
  const auto bits = static_cast<std::make_unsigned_t<Integer>>(value);
  for (std::size_t k = 0; k < sizeof(Integer); ++k) {
    bytes.push_back(static_cast<typename Bytes::value_type>(
        static_cast<std::uint8_t>((bits >> (8 * k)) & 0xFF)));
  }
}

}  // namespace symscene
