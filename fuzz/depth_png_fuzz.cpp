#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "symscene/io/image.hpp"

/// Any bytes are a depth image that keeps its bits when written and read, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto image = fuzz::accepted([&] { return parse_depth_png(bytes, "fuzz"); });
  if (image && parse_depth_png(format_png(*image), "again").values != image->values) std::abort();
  return 0;
}
