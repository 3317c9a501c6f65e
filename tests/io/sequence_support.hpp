#pragma once

#include <filesystem>

#include "io/image_support.hpp"
#include "symscene/io/sequence.hpp"

namespace symscene::io_test {

constexpr ImageSize frame_size{8, 6};

inline CameraIntrinsics small_camera() {
  return {frame_size.width, frame_size.height, 10.0, 11.0, 3.5, 2.5};
}

/// Depth in whole millimetres, different for every `i`, with one pixel without measurement.
inline DepthFrame small_frame(int i, bool color = true) {
  DepthFrame frame;
  frame.time = 100.0 + 0.04 * i;
  for (std::size_t k = 0; k < frame_size.pixels(); ++k) {
    frame.depth.push_back(static_cast<float>(500 + 10 * i + static_cast<int>(k)) / 1000.0F);
  }
  frame.depth[5] = 0.0F;
  if (color) frame.colors = color_ramp(frame_size).pixels;
  return frame;
}

inline Eigen::Isometry3d small_pose(int i) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(0.1 * i, Eigen::Vector3d::UnitY()).toRotationMatrix();
  pose.translation() << 0.1 * i, 0.2, -0.3;
  return pose;
}

/// The depth image of small_frame(i) in any scale.
inline std::string small_depth_png(int i, float scale = 1000.0F) {
  DepthImage image{frame_size, {}};
  for (const float depth : small_frame(i).depth) {
    image.values.push_back(static_cast<std::uint16_t>(std::lround(depth * scale)));
  }
  return format_png(image);
}

inline void write_image(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::create_directories(path.parent_path());
  write_text(path, bytes);
}

/// Equal depths up to rounding, and equal colours.
inline void expect_same_frame(const DepthFrame& a, const DepthFrame& b, double time_tolerance = 0) {
  EXPECT_NEAR(a.time, b.time, time_tolerance);
  ASSERT_EQ(a.depth.size(), b.depth.size());
  for (std::size_t i = 0; i < a.depth.size(); ++i) EXPECT_NEAR(a.depth[i], b.depth[i], 1e-6);
  EXPECT_TRUE(same_bits(a.colors, b.colors));
}

inline SequenceOptions given_camera(std::optional<double> depth_scale = std::nullopt) {
  return {CameraIntrinsics{0, 0, 10.0, 11.0, 3.5, 2.5}, depth_scale};
}

}  // namespace symscene::io_test
