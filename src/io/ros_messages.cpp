#include "ros_messages.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "byte_cursor.hpp"
#include "image_formats.hpp"
#include "text.hpp"

namespace symscene {
namespace {

/// Reads the header at the beginning of messages. Returns the frame id.
std::string take_header(ByteCursor& bytes) {
  bytes.take(12);  // sequence number and time
  return std::string(bytes.block());
}

std::size_t bytes_a_pixel(std::string_view encoding) {
  if (encoding == "32FC1" || encoding == "rgba8" || encoding == "bgra8") return 4;
  return is_color_encoding(encoding) ? 3 : 2;
}

/// Throws InputError unless the data contain all rows.
void require_rows(const RosImage& image, const std::string& name) {
  require_image_size(image.size.width, image.size.height, name);
  const std::size_t row = bytes_a_pixel(image.encoding) * image.size.width;
  const std::size_t needed = std::size_t{image.step} * (image.size.height - 1) + row;
  if (image.step < row || image.data.size() < needed) {
    throw InputError(name,
                     fmt::format("an image of {}×{} {} pixels", image.size.width, image.size.height,
                                 image.encoding),
                     fmt::format("{} bytes in rows of {}", image.data.size(), image.step));
  }
}

template <class Number>
Number number_at(const char* bytes, bool swap) {
  Number value{};
  std::memcpy(&value, bytes, sizeof value);
  if (!swap) return value;
  if constexpr (sizeof(Number) == 2) return static_cast<Number>(__builtin_bswap16(value));
  if constexpr (sizeof(Number) == 4) return __builtin_bswap32(value);
}

/// Calls put(pixel, bytes of the pixel) for all pixels.
template <class Put>
void for_each_pixel(const RosImage& image, const Put& put) {
  const std::size_t stride = bytes_a_pixel(image.encoding);
  std::size_t pixel = 0;
  for (Index row = 0; row < image.size.height; ++row) {
    const char* bytes = image.data.data() + std::size_t{row} * image.step;
    for (Index column = 0; column < image.size.width; ++column, bytes += stride) {
      put(pixel++, bytes);
    }
  }
}

float measured(float depth) { return std::isfinite(depth) && depth > 0.0F ? depth : 0.0F; }

}  // namespace

bool is_depth_encoding(std::string_view encoding) {
  return encoding == "16UC1" || encoding == "mono16" || encoding == "32FC1";
}

bool is_color_encoding(std::string_view encoding) {
  return encoding == "rgb8" || encoding == "bgr8" || encoding == "rgba8" || encoding == "bgra8";
}

double default_depth_scale(std::string_view encoding) { return encoding == "32FC1" ? 1.0 : 1000.0; }

RosImage parse_ros_image(std::string_view bytes, const std::string& name) {
  ByteCursor rest(bytes, name, "a message sensor_msgs/Image");
  RosImage image;
  image.frame_id = take_header(rest);
  image.size.height = rest.number<std::uint32_t>();
  image.size.width = rest.number<std::uint32_t>();
  image.encoding = std::string(rest.block());
  image.big_endian = rest.number<std::uint8_t>() != 0;
  image.step = rest.number<std::uint32_t>();
  image.data = rest.block();
  return image;
}

RosCameraInfo parse_ros_camera_info(std::string_view bytes, const std::string& name) {
  ByteCursor rest(bytes, name, "a message sensor_msgs/CameraInfo");
  take_header(rest);
  RosCameraInfo info;
  const auto height = rest.number<std::uint32_t>();
  const auto width = rest.number<std::uint32_t>();
  rest.block();  // name of the distortion model
  for (auto left = rest.number<std::uint32_t>(); left > 0; --left) {
    if (rest.number<double>() != 0.0) info.distorted = true;
  }
  std::array<double, 9> k{};
  for (double& value : k) value = rest.number<double>();
  rest.take(9 * sizeof(double));  // R
  std::array<double, 12> p{};
  for (double& value : p) value = rest.number<double>();
  info.raw = {width, height, k[0], k[4], k[2], k[5]};
  info.rectified = {width, height, p[0], p[5], p[2], p[6]};
  return info;
}

std::vector<float> depth_of(const RosImage& image, double scale, const std::string& name) {
  require_rows(image, name);
  const bool swap = image.big_endian != (std::endian::native == std::endian::big);
  const auto divisor = static_cast<float>(scale);
  std::vector<float> depth(image.size.pixels());
  if (image.encoding == "32FC1") {
    for_each_pixel(image, [&](std::size_t pixel, const char* bytes) {
      const auto bits = number_at<std::uint32_t>(bytes, swap);
      depth[pixel] = measured(std::bit_cast<float>(bits) / divisor);
    });
  } else {
    for_each_pixel(image, [&](std::size_t pixel, const char* bytes) {
      depth[pixel] = static_cast<float>(number_at<std::uint16_t>(bytes, swap)) / divisor;
    });
  }
  return depth;
}

Colors colors_of(const RosImage& image, const std::string& name) {
  require_rows(image, name);
  Colors colors(static_cast<Eigen::Index>(image.size.pixels()), 3);
  const int red = image.encoding.starts_with("bgr") ? 2 : 0;
  for_each_pixel(image, [&](std::size_t pixel, const char* bytes) {
    const auto channel = [&](int i) { return static_cast<std::uint8_t>(bytes[i]); };
    colors.row(static_cast<Eigen::Index>(pixel)) << channel(red), channel(1), channel(2 - red);
  });
  return colors;
}

}  // namespace symscene
