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

/// Depth in metres is stored as quantised inverse depth; 0 is no measurement.
std::vector<float> compressed_depth_of(const RosImage& image, double scale,
                                       const std::string& name) {
  const DepthImage png = parse_depth_png(image.data, name);
  const auto divisor = static_cast<float>(scale);
  const bool is_inverse = image.encoding == "32FC1";
  std::vector<float> depth(png.values.size());
  for (std::size_t i = 0; i < depth.size(); ++i) {
    const auto value = static_cast<float>(png.values[i]);
    if (value == 0.0F) continue;
    const float raw = is_inverse ? image.quantization[0] / (value - image.quantization[1]) : value;
    depth[i] = measured(raw / divisor);
  }
  return depth;
}

}  // namespace

bool is_depth_encoding(std::string_view encoding) {
  return encoding == "16UC1" || encoding == "mono16" || encoding == "32FC1";
}

bool is_color_encoding(std::string_view encoding) {
  return encoding == "rgb8" || encoding == "bgr8" || encoding == "rgba8" || encoding == "bgra8";
}

double default_depth_scale(std::string_view encoding) { return encoding == "32FC1" ? 1.0 : 1000.0; }

RosImage parse_ros_image(std::string_view bytes, RosFormat format, const std::string& name) {
  RosCursor rest(bytes, format, name, "a message sensor_msgs/Image");
  RosImage image;
  image.header = rest.header();
  image.size.height = rest.number<std::uint32_t>();
  image.size.width = rest.number<std::uint32_t>();
  image.encoding = rest.text();
  image.big_endian = rest.number<std::uint8_t>() != 0;
  image.step = rest.number<std::uint32_t>();
  image.data = rest.data();
  return image;
}

RosCameraInfo parse_ros_camera_info(std::string_view bytes, RosFormat format,
                                    const std::string& name) {
  RosCursor rest(bytes, format, name, "a message sensor_msgs/CameraInfo");
  rest.header();
  RosCameraInfo info;
  const auto height = rest.number<std::uint32_t>();
  const auto width = rest.number<std::uint32_t>();
  rest.text();  // name of the distortion model
  for (auto left = rest.count(sizeof(double)); left > 0; --left) {
    if (rest.number<double>() != 0.0) info.distorted = true;
  }
  std::array<double, 9> k{};
  for (double& value : k) value = rest.number<double>();
  for (int i = 0; i < 9; ++i) rest.number<double>();  // R
  std::array<double, 12> p{};
  for (double& value : p) value = rest.number<double>();
  info.raw = {width, height, k[0], k[4], k[2], k[5]};
  info.rectified = {width, height, p[0], p[5], p[2], p[6]};
  return info;
}

RosImage parse_ros_compressed_image(std::string_view bytes, RosFormat format,
                                    const std::string& name) {
  const char* what = "a message sensor_msgs/CompressedImage";
  RosCursor rest(bytes, format, name, what);
  RosImage image;
  image.compressed = true;
  image.header = rest.header();
  const std::string kind = rest.text();
  image.data = rest.data();
  image.encoding = kind;
  const std::string pixels = kind.substr(0, kind.find(';'));
  const bool is_depth = kind.find("compressedDepth") != std::string::npos;
  if (is_depth) {  // ConfigHeader of compressed_depth_image_transport stands before the PNG
    ByteCursor data(image.data, name, what);
    data.take(sizeof(std::uint32_t));
    for (float& value : image.quantization) {
      value = std::bit_cast<float>(data.number<std::uint32_t>());
    }
    image.data = data.take(data.left());
  }
  if (!is_png(image.data) && (is_depth || !is_jpeg(image.data))) return image;
  image.size = parse_image_size(image.data, name);
  if (is_depth || is_depth_encoding(pixels)) {
    image.encoding = pixels;
  } else {
    image.encoding = "rgb8";
  }
  return image;
}

std::vector<float> depth_of(const RosImage& image, double scale, const std::string& name) {
  if (image.compressed) return compressed_depth_of(image, scale, name);
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
  if (image.compressed) return parse_color_image(image.data, name).pixels;
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
