#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace symscene {

/// The number types of PLY and PCD.
enum class ScalarType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64
};

/// Calls visit(T{}) for the C++ type T of `type`.
template <class Visit>
decltype(auto) with_scalar_type(ScalarType type, Visit&& visit) {
  switch (type) {
    case ScalarType::int8:
      return visit(std::int8_t{});
    case ScalarType::uint8:
      return visit(std::uint8_t{});
    case ScalarType::int16:
      return visit(std::int16_t{});
    case ScalarType::uint16:
      return visit(std::uint16_t{});
    case ScalarType::int32:
      return visit(std::int32_t{});
    case ScalarType::uint32:
      return visit(std::uint32_t{});
    case ScalarType::int64:
      return visit(std::int64_t{});
    case ScalarType::uint64:
      return visit(std::uint64_t{});
    case ScalarType::float32:
      return visit(float{});
    case ScalarType::float64:
      break;
  }
  return visit(double{});
}

inline std::size_t size_of(ScalarType type) {
  return with_scalar_type(type, [](auto zero) { return sizeof(zero); });
}

inline bool is_float(ScalarType type) {
  return type == ScalarType::float32 || type == ScalarType::float64;
}

/// The value at `bytes`, in the byte order of the machine or, if `swap`, the opposite one.
template <class T>
T load(const char* bytes, bool swap = std::endian::native != std::endian::little) {
  char buffer[sizeof(T)];
  std::memcpy(buffer, bytes, sizeof(T));
  if (swap) std::reverse(buffer, buffer + sizeof(T));
  T value;
  std::memcpy(&value, buffer, sizeof(T));
  return value;
}

inline double load_as_double(ScalarType type, const char* bytes, bool swap) {
  return with_scalar_type(
      type, [&](auto zero) { return static_cast<double>(load<decltype(zero)>(bytes, swap)); });
}

/// Values of one type, `stride` bytes apart.
struct ScalarColumn {
  const char* first;
  std::size_t stride;
  std::size_t count;
  ScalarType type;
  bool swap;  ///< the byte order is opposite to the machine's
};

/// Converts a column to floats.
inline void copy_column(const ScalarColumn& column, float* out) {
  with_scalar_type(column.type, [&](auto zero) {
    const char* from = column.first;
    for (std::size_t i = 0; i < column.count; ++i, from += column.stride) {
      out[i] = static_cast<float>(load<decltype(zero)>(from, column.swap));
    }
  });
}

/// Appends the little-endian bytes of `value`.
template <class Buffer, class T>
void append_scalar(Buffer& buffer, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  if constexpr (std::endian::native != std::endian::little) {
    std::reverse(bytes, bytes + sizeof(T));
  }
  buffer.append(bytes, sizeof(T));
}

}  // namespace symscene
