#include "lzf.hpp"

#include <cstdint>

namespace symscene {
namespace {

/// Removes a byte from the front; returns nothing at the end.
std::optional<std::size_t> take_byte(std::string_view& stream) {
  if (stream.empty()) return std::nullopt;
  const auto byte = static_cast<std::uint8_t>(stream.front());
  stream.remove_prefix(1);
  return byte;
}

/// Control byte 000LLLLL: L + 1 literal bytes follow.
bool copy_literals(std::string_view& stream, std::size_t control, std::string& out) {
  const std::size_t length = control + 1;
  if (length > stream.size()) return false;
  out.append(stream.substr(0, length));
  stream.remove_prefix(length);
  return true;
}

/// Control byte LLLHHHHH, one more byte of L if L is 7, then the low byte of the distance whose
/// high bits are H: L + 2 bytes are repeated from distance + 1 back. Source and copy may overlap.
bool copy_reference(std::string_view& stream, std::size_t control, std::string& out) {
  std::size_t length = (control >> 5) + 2;
  if (length == 9) {
    const auto more = take_byte(stream);
    if (!more) return false;
    length += *more;
  }
  const auto low = take_byte(stream);
  if (!low) return false;
  const std::size_t distance = ((control & 31) << 8) + *low + 1;
  if (distance > out.size()) return false;
  for (std::size_t i = 0; i < length; ++i) out.push_back(out[out.size() - distance]);
  return true;
}

}  // namespace

std::optional<std::string> decompress_lzf(std::string_view stream, std::size_t size) {
  if (size / lzf_largest_growth > stream.size()) return std::nullopt;
  std::string out;
  out.reserve(size);
  while (const auto control = take_byte(stream)) {
    const bool good = *control < 32 ? copy_literals(stream, *control, out)
                                    : copy_reference(stream, *control, out);
    if (!good || out.size() > size) return std::nullopt;
  }
  if (out.size() != size) return std::nullopt;
  return out;
}

}  // namespace symscene
