#include "reconstruction/dominant_plane.hpp"

#include <random>

#include <gtest/gtest.h>

#include "reconstruction/analytic_scenes.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

/// The image of bodies with noise in proportion to the squared depth.
SurfaceImage noisy_image(const Bodies& bodies) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal(0.0F, static_cast<float>(axial_noise));
  std::vector<float> depth = render(bodies, half_vga(), Eigen::Isometry3d::Identity()).depth;
  for (float& z : depth) z += normal(random) * z * z;
  return find_surface(std::move(depth), half_vga(), {});
}

const Eigen::Vector3d table_normal = Eigen::Vector3d(0.1, -0.6, -0.8).normalized();

TEST(DominantPlane, OfATableWithABallHasOneNormalAndTheBallKeepsItsOwn) {
  const SurfaceImage before =
      noisy_image({plane(table_normal, 1.6), sphere({0.0, 0.0, 1.6}, 0.15)});
  SurfaceImage after = before;
  ASSERT_TRUE(flatten_dominant_plane(after, axial_noise));
  std::size_t flat = 0, kept = 0, shown = 0;
  const Eigen::Vector3d found = normal_of(after.pixels[20 * 320 + 20]);
  EXPECT_GT(found.dot(table_normal), std::cos(0.005));
  for (std::size_t i = 0; i < after.pixels.size(); ++i) {
    if (!before.pixels[i].shows_surface()) continue;
    ++shown;
    EXPECT_EQ(after.pixels[i].depth, before.pixels[i].depth);
    if (normal_of(after.pixels[i]) == found) ++flat;
    if (normal_of(after.pixels[i]) == normal_of(before.pixels[i])) ++kept;
  }
  EXPECT_EQ(flat + kept, shown);
  EXPECT_GT(static_cast<double>(flat), 0.9 * static_cast<double>(shown));
  EXPECT_GT(kept, 1000U);  // a ball of 49 pixels in diameter shows 1900
}

TEST(DominantPlane, IsNotFoundOnABall) {
  SurfaceImage image = noisy_image({sphere({0.0, 0.0, 0.8}, 0.3)});
  const std::vector<SurfacePixel> before = image.pixels;
  EXPECT_FALSE(flatten_dominant_plane(image, axial_noise));
  for (std::size_t i = 0; i < before.size(); ++i)
    ASSERT_EQ(normal_of(image.pixels[i]), normal_of(before[i]));
}

TEST(DominantPlane, IsNoneOfTwoWallsThatShareTheImage) {
  SurfaceImage image = noisy_image({plane(Eigen::Vector3d(-1, 0, -1).normalized(), 1.0),
                                    plane(Eigen::Vector3d(1, 0, -1).normalized(), 1.0)});
  EXPECT_FALSE(flatten_dominant_plane(image, axial_noise, {.min_share = 0.6}));
}

TEST(DominantPlane, IsNoneOfAnEmptyImage) {
  SurfaceImage image{half_vga(), std::vector<SurfacePixel>(half_vga().pixels())};
  EXPECT_FALSE(flatten_dominant_plane(image, axial_noise));
}

}  // namespace
}  // namespace symscene
