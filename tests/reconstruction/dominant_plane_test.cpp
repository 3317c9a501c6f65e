#include "reconstruction/dominant_plane.hpp"

#include <random>

#include <gtest/gtest.h>

#include "reconstruction/analytic_scenes.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

constexpr double noise = 1.425e-3;  // [1/m]

CameraIntrinsics camera() { return {320, 240, 262.5, 262.5, 159.5, 119.5}; }

/// The image of bodies with noise in proportion to the squared depth.
SurfaceImage noisy_image(const Bodies& bodies) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal(0.0F, static_cast<float>(noise));
  std::vector<float> depth = render(bodies, camera(), Eigen::Isometry3d::Identity()).depth;
  for (float& z : depth) z += normal(random) * z * z;
  return find_surface(std::move(depth), camera(), {});
}

Eigen::Vector3f normal_at(const SurfacePixel& pixel) { return {pixel.nx, pixel.ny, pixel.nz}; }

const Eigen::Vector3d table_normal = Eigen::Vector3d(0.1, -0.6, -0.8).normalized();

TEST(DominantPlane, OfATableWithABallHasOneNormalAndTheBallKeepsItsOwn) {
  const SurfaceImage before =
      noisy_image({plane(table_normal, 1.6), sphere({0.0, 0.0, 1.6}, 0.15)});
  SurfaceImage after = before;
  ASSERT_TRUE(flatten_dominant_plane(after, noise));
  std::size_t flat = 0, kept = 0, shown = 0;
  const Eigen::Vector3f found = normal_at(after.pixels[20 * 320 + 20]);
  EXPECT_GT(found.dot(table_normal.cast<float>()), std::cos(0.005F));
  for (std::size_t i = 0; i < after.pixels.size(); ++i) {
    if (!before.pixels[i].shows_surface()) continue;
    ++shown;
    EXPECT_EQ(after.pixels[i].depth, before.pixels[i].depth);
    if (normal_at(after.pixels[i]) == found) ++flat;
    if (normal_at(after.pixels[i]) == normal_at(before.pixels[i])) ++kept;
  }
  EXPECT_EQ(flat + kept, shown);
  EXPECT_GT(static_cast<double>(flat), 0.9 * static_cast<double>(shown));
  EXPECT_GT(kept, 1000U);  // a ball of 49 pixels in diameter shows 1900
}

TEST(DominantPlane, IsNotFoundOnABall) {
  SurfaceImage image = noisy_image({sphere({0.0, 0.0, 0.8}, 0.3)});
  const std::vector<SurfacePixel> before = image.pixels;
  EXPECT_FALSE(flatten_dominant_plane(image, noise));
  for (std::size_t i = 0; i < before.size(); ++i)
    ASSERT_EQ(normal_at(image.pixels[i]), normal_at(before[i]));
}

TEST(DominantPlane, IsNoneOfTwoWallsThatShareTheImage) {
  SurfaceImage image = noisy_image({plane(Eigen::Vector3d(-1, 0, -1).normalized(), 1.0),
                                    plane(Eigen::Vector3d(1, 0, -1).normalized(), 1.0)});
  EXPECT_FALSE(flatten_dominant_plane(image, noise, {.min_share = 0.6}));
}

TEST(DominantPlane, IsNoneOfAnEmptyImage) {
  SurfaceImage image{camera(), std::vector<SurfacePixel>(camera().pixels())};
  EXPECT_FALSE(flatten_dominant_plane(image, noise));
}

}  // namespace
}  // namespace symscene
