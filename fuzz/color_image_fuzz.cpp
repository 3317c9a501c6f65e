#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "io/image_formats.hpp"
#include "symscene/io/image.hpp"

/// Any bytes are a colour image, PNG or JPEG, of the size in its header, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  const auto image = fuzz::accepted([&] { return parse_color_image(bytes, "fuzz"); });
  if (image && parse_image_size(bytes, "fuzz") != image->size) std::abort();
  return 0;
}
