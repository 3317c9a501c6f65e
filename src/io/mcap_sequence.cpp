// A sequence as messages of ROS 2.
#include "cdr_writer.hpp"
#include "core/little_endian.hpp"
#include "depth_millimetres.hpp"
#include "io/pose_json.hpp"
#include "mcap_writer.hpp"
#include "ros_json.hpp"
#include "symscene/io/mcap.hpp"

namespace symscene {
namespace {

constexpr const char* camera_frame = "camera_depth_optical_frame";

constexpr const char* separator =
    "\n================================================================================\nMSG: ";
constexpr const char* header_definition =
    "std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id";
constexpr const char* time_definition = "builtin_interfaces/Time\nint32 sec\nuint32 nanosec";

/// The text of a type followed by those of the types that it refers to.
std::string definition_of(const std::string& fields, std::initializer_list<const char*> parts) {
  std::string text = fields;
  for (const char* part : parts) text += std::string(separator) + part;
  return text;
}

std::string image_definition() {
  return definition_of(
      "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 "
      "is_bigendian\nuint32 step\nuint8[] data",
      {header_definition, time_definition});
}

std::string camera_info_definition() {
  return definition_of(
      "std_msgs/Header header\nuint32 height\nuint32 width\nstring distortion_model\nfloat64[] "
      "d\nfloat64[9] k\nfloat64[9] r\nfloat64[12] p\nuint32 binning_x\nuint32 "
      "binning_y\nsensor_msgs/RegionOfInterest roi",
      {header_definition, time_definition,
       "sensor_msgs/RegionOfInterest\nuint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 "
       "width\nbool do_rectify"});
}

std::string transforms_definition() {
  return definition_of(
      "geometry_msgs/TransformStamped[] transforms",
      {"geometry_msgs/TransformStamped\nstd_msgs/Header header\nstring "
       "child_frame_id\ngeometry_msgs/Transform transform",
       "geometry_msgs/Transform\ngeometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion "
       "rotation",
       "geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z",
       "geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w", header_definition,
       time_definition});
}

std::string image_message(std::uint64_t time, const CameraIntrinsics& camera, const char* encoding,
                          std::uint32_t pixel, std::string_view data) {
  CdrWriter message;
  message.header(time, camera_frame);
  message.number(std::uint32_t{camera.height}).number(std::uint32_t{camera.width});
  message.text(encoding).number(std::uint8_t{0});
  message.number(std::uint32_t{camera.width} * pixel).data(data);
  return message.finish();
}

std::string depth_bytes(const std::vector<float>& depth) {
  std::string bytes;
  bytes.reserve(2 * depth.size());
  for (const std::uint16_t value : to_millimetres(depth)) append_little_endian(bytes, value);
  return bytes;
}

std::string color_bytes(const Colors& colors) {
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(colors.size()));
  for (Eigen::Index i = 0; i < colors.rows(); ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      bytes.push_back(static_cast<char>(colors(i, channel)));
    }
  }
  return bytes;
}

std::string camera_info_message(std::uint64_t time, const CameraIntrinsics& c) {
  CdrWriter message;
  message.header(time, camera_frame);
  message.number(std::uint32_t{c.height}).number(std::uint32_t{c.width});
  message.text("plumb_bob").number(std::uint32_t{5});
  for (int i = 0; i < 5; ++i) message.number(0.0);
  for (const double k : {c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0}) message.number(k);
  for (const double r : {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}) message.number(r);
  for (const double p : {c.fx, 0.0, c.cx, 0.0, 0.0, c.fy, c.cy, 0.0, 0.0, 0.0, 1.0, 0.0}) {
    message.number(p);
  }
  for (int i = 0; i < 6; ++i) message.number(std::uint32_t{0});  // binning and region of interest
  message.number(std::uint8_t{0});
  return message.finish();
}

std::string transform_message(std::uint64_t time, const Eigen::Isometry3d& T_world_camera) {
  CdrWriter message;
  message.number(std::uint32_t{1}).header(time, "world").text(camera_frame);
  for (const double value : T_world_camera.translation()) message.number(value);
  const Eigen::Quaterniond rotation = orientation_of(T_world_camera);
  for (const double value : rotation.coeffs()) message.number(value);
  return message.finish();
}

McapChannel ros2_channel(const char* topic, const char* type) {
  return {topic, "cdr", type, "ros2msg"};
}

}  // namespace

std::string format_sequence_mcap(const DepthSequence& sequence, McapCompression compression) {
  McapWriter writer("ros2", compression);
  const auto info =
      writer.add_channel(ros2_channel("/camera/depth/camera_info", "sensor_msgs/msg/CameraInfo"),
                         camera_info_definition());
  const auto depth = writer.add_channel(
      ros2_channel("/camera/depth/image_rect_raw", "sensor_msgs/msg/Image"), image_definition());
  const auto color = writer.add_channel(
      ros2_channel("/camera/color/image_raw", "sensor_msgs/msg/Image"), image_definition());
  const auto tf =
      writer.add_channel(ros2_channel("/tf", "tf2_msgs/msg/TFMessage"), transforms_definition());
  const CameraIntrinsics& camera = sequence.camera();
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const DepthFrame frame = sequence.read(i);
    const auto time =
        static_cast<std::uint64_t>(std::max<std::int64_t>(0, nanoseconds_of(frame.time)));
    if (const auto pose = sequence.pose(i)) {
      writer.add_message(tf, time, transform_message(time, *pose));
    }
    writer.add_message(info, time, camera_info_message(time, camera));
    writer.add_message(depth, time,
                       image_message(time, camera, "16UC1", 2, depth_bytes(frame.depth)));
    if (frame.colors.rows() != 0) {
      writer.add_message(color, time,
                         image_message(time, camera, "rgb8", 3, color_bytes(frame.colors)));
    }
  }
  return writer.finish();
}

}  // namespace symscene
