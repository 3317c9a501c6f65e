#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "symscene/core/error.hpp"

namespace symscene {

/// How a message of ROS is serialised.
enum class RosFormat : std::uint8_t {
  ros1,  ///< little endian, packed
  cdr    ///< of ROS 2: OMG's Common Data Representation, version 1 (XCDR1), of either byte order
};

/// Header of messages: when and in which frame they were measured.
struct RosHeader {
  double time = 0.0;  ///< [s]
  std::string frame_id;
};

/// Reads the fields of a message of ROS 1 or ROS 2 in their order. Every member throws InputError
/// where the bytes end too early.
class RosCursor {
 public:
  /// `name` is the file in messages, `what` describes the bytes; both must outlive the cursor.
  RosCursor(std::string_view bytes, RosFormat format, const std::string& name, const char* what)
      : body_(bytes), name_(&name), what_(what), cdr_(format == RosFormat::cdr) {
    if (cdr_) take_encapsulation();
  }

  std::size_t left() const { return body_.size() - position_; }

  template <class Number>
  Number number() {
    align(sizeof(Number));
    const std::string_view bytes = take(sizeof(Number));
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      const std::size_t place = big_endian_ ? sizeof(Number) - 1 - i : i;
      bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * place);
    }
    if constexpr (sizeof(Number) == 8) {
      return std::bit_cast<Number>(bits);
    } else {
      return static_cast<Number>(bits);
    }
  }

  /// A string. CDR ends it with a zero, which belongs to its length.
  std::string text() {
    std::string_view bytes = take(number<std::uint32_t>());
    if (cdr_ && !bytes.empty()) bytes.remove_suffix(1);
    return std::string(bytes);
  }

  /// A sequence of bytes.
  std::string_view data() { return take(number<std::uint32_t>()); }

  /// The length of a sequence whose elements have at least `element` bytes.
  std::uint32_t count(std::size_t element) {
    const auto count = number<std::uint32_t>();
    if (count > left() / element) fail(fmt::format("{} elements in {} bytes", count, left()));
    return count;
  }

  RosHeader header() {
    if (!cdr_) number<std::uint32_t>();  // sequence number
    const auto seconds = number<std::uint32_t>();
    const auto nanoseconds = number<std::uint32_t>();
    return {static_cast<double>(seconds) + 1e-9 * nanoseconds, text()};
  }

 private:
  /// Two bytes of the representation, two of options; fields are aligned relative to what follows.
  void take_encapsulation() {
    const std::string_view bytes = take(4);
    if (bytes[0] != 0 || (bytes[1] != 0 && bytes[1] != 1)) {
      fail(fmt::format("the representation {:02x}{:02x} in place of CDR's 0000 or 0001",
                       static_cast<unsigned char>(bytes[0]), static_cast<unsigned char>(bytes[1])));
    }
    big_endian_ = bytes[1] == 0;
    body_.remove_prefix(4);
    position_ = 0;
  }

  void align(std::size_t size) {
    if (cdr_) take((size - position_ % size) % size);
  }

  std::string_view take(std::size_t size) {
    if (size > left()) fail(fmt::format("{} bytes where {} should be", left(), size));
    const std::string_view taken = body_.substr(position_, size);
    position_ += size;
    return taken;
  }

  [[noreturn]] void fail(const std::string& found) const { throw InputError(*name_, what_, found); }

  std::string_view body_;
  std::size_t position_ = 0;
  const std::string* name_;
  const char* what_;
  bool cdr_;
  bool big_endian_ = false;
};

}  // namespace symscene
