#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "ros_cursor.hpp"
#include "symscene/core/camera.hpp"
#include "symscene/io/image.hpp"

namespace symscene {

/// A message sensor_msgs/Image or sensor_msgs/CompressedImage; `data` refers to the bytes that it
/// was parsed from.
struct RosImage {
  RosHeader header;
  ImageSize size;
  std::string encoding;
  bool big_endian = false;
  std::uint32_t step = 0;  ///< distance of rows [byte]
  std::string_view data;   ///< pixels, or if `compressed` a PNG or JPEG
  bool compressed = false;
  /// Of compressed depth in metres: the depth is q[0] / (value − q[1]). [m], [1]
  std::array<float, 2> quantization{};
};

/// A message sensor_msgs/CameraInfo.
struct RosCameraInfo {
  CameraIntrinsics raw;        ///< K
  CameraIntrinsics rectified;  ///< P
  bool distorted = false;      ///< whether a number of D is not 0
};

// Throw InputError if the bytes are not a message of this type; `name` is the name of the file.
RosImage parse_ros_image(std::string_view bytes, RosFormat format, const std::string& name);
RosCameraInfo parse_ros_camera_info(std::string_view bytes, RosFormat format,
                                    const std::string& name);
/// Depth of image_transport's `compressedDepth` or `compressed` as PNG, or colour as PNG or JPEG.
/// The encoding of others is their format, which is neither that of depth nor of colour.
RosImage parse_ros_compressed_image(std::string_view bytes, RosFormat format,
                                    const std::string& name);

bool is_depth_encoding(std::string_view encoding);  ///< 16UC1, mono16 or 32FC1
bool is_color_encoding(std::string_view encoding);  ///< rgb8, bgr8, rgba8 or bgra8

/// The default value of a depth image that is 1 m. [1/m]
double default_depth_scale(std::string_view encoding);

/// Depth, 0 where there is no measurement. [m]
std::vector<float> depth_of(const RosImage& image, double scale, const std::string& name);
Colors colors_of(const RosImage& image, const std::string& name);

}  // namespace symscene
