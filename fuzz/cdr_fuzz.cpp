#include <string>

#include "accepted.hpp"
#include "io/ros_messages.hpp"
#include "io/ros_transforms.hpp"

/// Any bytes are a message of ROS 1 or ROS 2, or refused. The first byte chooses type and format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace symscene;
  if (size == 0) return 0;
  const std::string_view bytes = fuzz::as_bytes(data, size).substr(1);
  const RosFormat format = (data[0] & 4) != 0 ? RosFormat::ros1 : RosFormat::cdr;
  const std::string name = "fuzz";
  fuzz::accepted([&] {
    const int type = data[0] & 3;
    if (type == 0) parse_ros_camera_info(bytes, format, name);
    if (type == 1) parse_ros_transforms(bytes, format, name);
    if (type < 2) return true;
    const RosImage image = type == 2 ? parse_ros_image(bytes, format, name)
                                     : parse_ros_compressed_image(bytes, format, name);
    if (is_depth_encoding(image.encoding)) depth_of(image, 1000.0, name);
    if (is_color_encoding(image.encoding)) colors_of(image, name);
    return true;
  });
  return 0;
}
