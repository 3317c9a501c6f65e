#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "symscene/io/result.hpp"

/// Any bytes are a result whose text stays the same when read and written again, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto result = fuzz::accepted([&] { return parse_objects_json(bytes, "fuzz", 100); });
  if (!result) return 0;
  const std::string text = format_objects_json(*result);
  if (format_objects_json(parse_objects_json(text, "again", 100)) != text) std::abort();
  return 0;
}
