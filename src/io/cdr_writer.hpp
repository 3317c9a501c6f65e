#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/little_endian.hpp"

namespace symscene {

/// Writes the fields of a message of ROS 2 in their order, in OMG's Common Data Representation
/// (XCDR1, little endian). RosCursor reads them.
class CdrWriter {
 public:
  template <class Number>
  CdrWriter& number(Number value) {
    body_.append((sizeof(Number) - body_.size() % sizeof(Number)) % sizeof(Number), '\0');
    if constexpr (sizeof(Number) == 8) {
      append_little_endian(body_, std::bit_cast<std::uint64_t>(value));
    } else {
      append_little_endian(body_, value);
    }
    return *this;
  }

  CdrWriter& text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size() + 1));
    body_.append(text).push_back('\0');
    return *this;
  }

  CdrWriter& data(std::string_view bytes) {
    number(static_cast<std::uint32_t>(bytes.size()));
    body_.append(bytes);
    return *this;
  }

  /// std_msgs/Header.
  CdrWriter& header(std::uint64_t nanoseconds, std::string_view frame) {
    number(static_cast<std::uint32_t>(nanoseconds / 1'000'000'000));
    number(static_cast<std::uint32_t>(nanoseconds % 1'000'000'000));
    return text(frame);
  }

  /// With the encapsulation before it.
  std::string finish() const { return std::string("\0\1\0\0", 4) + body_; }

 private:
  std::string body_;
};

}  // namespace symscene
