#include <cstdlib>
#include <string>

#include "accepted.hpp"
#include "io/ros_messages.hpp"

/// Any bytes are messages with an image, whose pixels fill it, or with a camera, or refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  const std::string_view bytes = fuzz::as_bytes(data, size);
  fuzz::accepted([&] { return parse_ros_camera_info(bytes, RosFormat::ros1, "fuzz"); });
  const auto image =
      fuzz::accepted([&] { return parse_ros_image(bytes, RosFormat::ros1, "fuzz"); });
  if (!image) return 0;
  const auto pixels =
      static_cast<std::size_t>(image->size.width) * static_cast<std::size_t>(image->size.height);
  const double scale = default_depth_scale(image->encoding);
  if (is_depth_encoding(image->encoding)) {
    const auto depth = fuzz::accepted([&] { return depth_of(*image, scale, "fuzz"); });
    if (depth && depth->size() != pixels) std::abort();
  }
  if (is_color_encoding(image->encoding)) {
    const auto colors = fuzz::accepted([&] { return colors_of(*image, "fuzz"); });
    if (colors && static_cast<std::size_t>(colors->rows()) != pixels) std::abort();
  }
  return 0;
}
