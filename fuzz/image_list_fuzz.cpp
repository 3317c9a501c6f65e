#include <cmath>
#include <cstdlib>

#include "accepted.hpp"
#include "file_of.hpp"
#include "io/image_files.hpp"
#include "io/image_lists.hpp"

/// Any bytes are the list of images of a TUM sequence, its associations or times of frames, in
/// order and finite, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  fuzz::accepted([&] { return parse_times(bytes, "fuzz"); });
  const fuzz::FileOf file(bytes);
  fuzz::accepted([&] { return read_associations(file.path()); });
  const auto images = fuzz::accepted([&] { return read_image_list(file.path()); });
  if (!images) return 0;
  for (std::size_t i = 0; i < images->size(); ++i) {
    if (!std::isfinite((*images)[i].time)) std::abort();
    if (i > 0 && (*images)[i].time < (*images)[i - 1].time) std::abort();
    nearest_image(*images, (*images)[i].time, 0.02);
  }
  return 0;
}
