#include "core/pixel_showing.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace symscene {
namespace {

const CameraIntrinsics small_camera{40, 30, 50.0, 50.0, 19.5, 14.5};

/// The left half of the image at 1 m, the right one at 2 m.
std::vector<float> step_image() {
  std::vector<float> depth(small_camera.pixels(), 1.0F);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (i % small_camera.width >= 20) depth[i] = 2.0F;
  }
  return depth;
}

Eigen::Vector3d point_at(double u, double v, double depth) {
  return depth * small_camera.ray(u, v);
}

TEST(PixelShowing, IsThatOfTheProjectionWhereTheImageMeasures) {
  const std::vector<float> depth = step_image();
  for (const Index v : {0U, 7U, 29U}) {
    for (const Index u : {0U, 19U, 20U, 39U})
      EXPECT_EQ(pixel_showing(point_at(u + 0.3, v - 0.2, 1.7), depth, small_camera), 40U * v + u);
  }
}

TEST(PixelShowing, IsOfTheMostSimilarDepthAtTheBorderOfAHole) {
  std::vector<float> depth = step_image();
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (i % small_camera.width >= 17 && i % small_camera.width <= 22) depth[i] = 0.0F;
  }
  // Both borders are three pixels away.
  for (const double z : {1.1, 1.9}) {
    const auto pixel = pixel_showing(point_at(19.4, 15, z), depth, small_camera);
    ASSERT_TRUE(pixel);
    EXPECT_EQ(depth[*pixel], 1.0F);  // the near border comes first
  }
  depth[15U * small_camera.width + 22] = 2.0F;
  for (const double z : {1.1, 1.9}) {
    const auto pixel = pixel_showing(point_at(19, 15, z), depth, small_camera);
    ASSERT_TRUE(pixel);
    EXPECT_EQ(depth[*pixel], z < 1.5 ? 1.0F : 2.0F);
  }
}

TEST(PixelShowing, IsNoneOutsideTheImageBehindTheCameraAndInGreatHoles) {
  const std::vector<float> depth = step_image();
  EXPECT_FALSE(pixel_showing(point_at(-1, 5, 1), depth, small_camera));
  EXPECT_FALSE(pixel_showing(point_at(5, 30, 1), depth, small_camera));
  EXPECT_FALSE(pixel_showing({0, 0, -1}, depth, small_camera));
  EXPECT_FALSE(pixel_showing(point_at(5, 5, 1), std::vector<float>(small_camera.pixels(), 0.0F),
                             small_camera));
}

}  // namespace
}  // namespace symscene
