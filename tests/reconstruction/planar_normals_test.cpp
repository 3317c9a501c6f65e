#include "reconstruction/planar_normals.hpp"

#include <gtest/gtest.h>

#include "reconstruction/analytic_scenes.hpp"
#include "reconstruction/surface_normals.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

/// The image of bodies with noise in proportion to the squared depth, without smooth normals.
SurfaceImage noisy_image(const Bodies& bodies, double sigma) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  DepthLevel level{half_vga(), render(bodies, half_vga(), Eigen::Isometry3d::Identity()).depth};
  for (float& z : level.depth) z += static_cast<float>(sigma * normal(random)) * z * z;
  return with_normals(smooth(level, 4.0F * static_cast<float>(axial_noise)), normal_reach, 0.015F);
}

SurfaceImage smoothed(SurfaceImage image) {
  smooth_planar_normals(image, axial_noise);
  return image;
}

/// The root mean square deviation of the normals from a direction. [rad]
double deviation_from(const SurfaceImage& image, const Eigen::Vector3d& normal) {
  double sum = 0.0, count = 0.0;
  for (const SurfacePixel& pixel : image.pixels) {
    if (!pixel.shows_surface()) continue;
    sum += (normal_of(pixel) - normal).squaredNorm();
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

double share_changed(const SurfaceImage& before, const SurfaceImage& after) {
  double changed = 0.0, count = 0.0;
  for (std::size_t i = 0; i < before.pixels.size(); ++i) {
    if (!before.pixels[i].shows_surface()) continue;
    count += 1.0;
    if (normal_of(before.pixels[i]) != normal_of(after.pixels[i])) changed += 1.0;
  }
  return changed / count;
}

TEST(PlanarNormals, OfANoisyTableHaveATenthOfTheNoise) {
  const Eigen::Vector3d normal = Eigen::Vector3d(0.1, -0.6, -0.8).normalized();
  const SurfaceImage image = noisy_image({plane(normal, 1.6)}, axial_noise);
  EXPECT_GT(deviation_from(image, normal), 0.1);
  EXPECT_LT(deviation_from(smoothed(image), normal), 0.01);
}

TEST(PlanarNormals, LeaveCurvedSurfacesAsTheyAre) {
  for (const double radius : {0.05, 0.15, 0.3}) {
    const SurfaceImage image = noisy_image({sphere({0, 0, 0.6 + radius}, radius)}, 0.0);
    EXPECT_LT(share_changed(image, smoothed(image)), 0.01) << radius;
  }
}

TEST(PlanarNormals, LeaveWhatStandsOnATable) {
  const Eigen::Vector3d up = -Eigen::Vector3d::UnitZ();
  const SurfaceImage image = noisy_image({plane(up, 1.0), sphere({0, 0, 0.97}, 0.04)}, 0.0);
  const SurfaceImage after = smoothed(image);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    if (image.pixels[i].depth > 0.99F) continue;
    EXPECT_EQ(normal_of(after.pixels[i]), normal_of(image.pixels[i]));
  }
}

TEST(PlanarNormals, KeepDepthsAndPixelsWithoutSurface) {
  const SurfaceImage image = noisy_image(tabletop(), axial_noise);
  const SurfaceImage after = smoothed(image);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    EXPECT_EQ(after.pixels[i].depth, image.pixels[i].depth);
    EXPECT_EQ(after.pixels[i].shows_surface(), image.pixels[i].shows_surface());
  }
}

TEST(PlanarNormals, AreTheSameForAnyNumberOfThreads) {
  const SurfaceImage image = noisy_image({plane(-Eigen::Vector3d::UnitZ(), 1.5)}, axial_noise);
  const SurfaceImage one = with_threads(1, [&] { return smoothed(image); });
  const SurfaceImage four = with_threads(4, [&] { return smoothed(image); });
  EXPECT_TRUE(same(one, four));
}

}  // namespace
}  // namespace symscene
