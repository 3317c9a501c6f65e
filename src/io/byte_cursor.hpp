#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {

/// Reads little-endian numbers and strings, as ROS 1 writes them, from the front of bytes.
class ByteCursor {
 public:
  /// `name` is the file in messages, `what` describes the bytes; both must outlive the cursor.
  ByteCursor(std::string_view bytes, const std::string& name, const char* what)
      : rest_(bytes), name_(&name), what_(what) {}

  bool at_end() const { return rest_.empty(); }
  std::size_t left() const { return rest_.size(); }

  std::string_view take(std::size_t size) {
    if (size > rest_.size()) {
      throw InputError(*name_, what_,
                       fmt::format("{} bytes where {} should be", rest_.size(), size));
    }
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  template <class Number>
  Number number() {
    const std::string_view bytes = take(sizeof(Number));
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    }
    Number value{};
    if constexpr (sizeof(Number) == 8) {
      std::memcpy(&value, &bits, sizeof value);
    } else {
      value = static_cast<Number>(bits);
    }
    return value;
  }

  /// Bytes that are preceded by their length in four bytes.
  std::string_view block() { return take(number<std::uint32_t>()); }

 private:
  std::string_view rest_;
  const std::string* name_;
  const char* what_;
};

}  // namespace symscene
