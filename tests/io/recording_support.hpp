#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "io/cdr_writer.hpp"
#include "io/mcap_writer.hpp"
#include "io/sequence_support.hpp"

namespace symscene::io_test {

/// A message and where it was recorded.
struct TestMessage {
  std::string topic;
  std::string type;        ///< "sensor_msgs/msg/Image"
  std::uint64_t time = 0;  ///< [ns]
  std::string data;
};
using TestMessages = std::vector<TestMessage>;

inline std::string mcap_of(const TestMessages& messages, const std::string& encoding = "cdr",
                           McapCompression compression = McapCompression::none) {
  McapWriter writer("ros2", compression);
  std::map<std::string, std::uint16_t> channels;
  for (const TestMessage& message : messages) {
    if (!channels.contains(message.topic)) {
      channels[message.topic] =
          writer.add_channel({message.topic, encoding, message.type, "ros2msg"}, "");
    }
    writer.add_message(channels[message.topic], message.time, message.data);
  }
  return writer.finish();
}

constexpr std::uint64_t second = 1'000'000'000;

inline std::uint64_t time_of(int i) {
  return static_cast<std::uint64_t>(std::llround(small_frame(i).time * 1e9));
}

inline std::string depth_bytes_of(int i) {
  std::string bytes;
  for (const float metres : small_frame(i).depth) {
    const auto value = static_cast<unsigned>(std::lround(metres * 1000.0F));
    bytes += static_cast<char>(value & 255U);
    bytes += static_cast<char>(value >> 8);
  }
  return bytes;
}

inline TestMessage depth_image(int i) {
  CdrWriter message;
  message.header(time_of(i), "camera").number(frame_size.height).number(frame_size.width);
  message.text("16UC1").number(std::uint8_t{0}).number(2 * frame_size.width);
  message.data(depth_bytes_of(i));
  return {"/camera/depth/image_raw", "sensor_msgs/msg/Image", time_of(i), message.finish()};
}

/// As image_transport's compressed topics: `data` behind the header and the format.
inline TestMessage compressed_image(int i, const std::string& topic, const std::string& format,
                                    const std::string& data) {
  CdrWriter message;
  message.header(time_of(i), "camera").text(format).data(data);
  return {topic, "sensor_msgs/msg/CompressedImage", time_of(i), message.finish()};
}

/// ConfigHeader of compressed_depth_image_transport: a format and two parameters.
inline std::string depth_config(float a, float b) {
  std::string bytes(12, '\0');
  std::memcpy(bytes.data() + 4, &a, sizeof a);
  std::memcpy(bytes.data() + 8, &b, sizeof b);
  return bytes;
}

inline TestMessage camera_info_beside(const std::string& topic) {
  const CameraIntrinsics c = small_camera();
  CdrWriter message;
  message.header(time_of(0), "camera").number(c.height).number(c.width);
  message.text("plumb_bob").number(std::uint32_t{5});
  for (int i = 0; i < 5; ++i) message.number(0.0);
  for (const double k : {c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0}) message.number(k);
  for (int i = 0; i < 21; ++i) message.number(0.0);  // R and P
  return {topic, "sensor_msgs/msg/CameraInfo", time_of(0), message.finish()};
}

inline TestMessage transform(const std::string& topic, std::uint64_t time,
                             const std::string& parent, const std::string& child,
                             const Eigen::Vector3d& translation,
                             const Eigen::Quaterniond& rotation = Eigen::Quaterniond::Identity()) {
  CdrWriter message;
  message.number(std::uint32_t{1}).header(time, parent).text(child);
  for (const double value : translation) message.number(value);
  for (const double value : rotation.coeffs()) message.number(value);
  return {topic, "tf2_msgs/msg/TFMessage", time, message.finish()};
}

/// Three depth images and their camera.
inline TestMessages small_recording() {
  return {camera_info_beside("/camera/depth/camera_info"), depth_image(0), depth_image(1),
          depth_image(2)};
}

inline void expect_small_recording(const DepthSequence& sequence) {
  EXPECT_EQ(sequence.camera().fy, 11.0);
  EXPECT_EQ(sequence.camera().height, frame_size.height);
  ASSERT_EQ(sequence.size(), 3U);
  for (int i : {2, 0, 1}) {
    expect_same_frame(sequence.read(static_cast<std::size_t>(i)), small_frame(i, false), 1e-6);
  }
}

}  // namespace symscene::io_test
