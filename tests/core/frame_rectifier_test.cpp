#include "symscene/core/frame_rectifier.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

constexpr LensDistortion lens{-0.2, 0.05, 0.002, -0.001, 0.01};
const CameraIntrinsics camera{160, 120, 131.0, 130.0, 79.0, 60.5};

DepthCorrection random_correction(std::uint64_t seed) {
  DepthCorrection grid{160, 120, 5, 4, 6, 0.5, 0.3, {}, {}};
  Random random(seed);
  for (std::size_t i = 0; i < grid.cells(); ++i) {
    grid.factors.push_back(static_cast<float>(random.uniform(0.9, 1.1)));
    grid.measured.push_back(1);
  }
  return grid;
}

DepthFrame random_frame(std::uint64_t seed) {
  DepthFrame frame;
  Random random(seed);
  for (std::size_t i = 0; i < camera.pixels(); ++i)
    frame.depth.push_back(random.chance(0.1) ? 0.0F : static_cast<float>(random.uniform(0.2, 3.0)));
  return frame;
}

TEST(LensDistortion, UndistortedIsTheInverseOfDistorted) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d ray(random.uniform(-0.7, 0.7), random.uniform(-0.5, 0.5));
    const auto again = lens.undistorted(lens.distorted(ray));
    ASSERT_TRUE(again);
    EXPECT_LT((*again - ray).norm(), 1e-10);
  }
}

TEST(LensDistortion, RaysBeyondTheFoldOfThePolynomialAreNotShown) {
  const LensDistortion folds{-0.5, 0.0, 0.0, 0.0, 0.0};  // r - 0.5 r³ has its maximum at 0.816
  EXPECT_TRUE(folds.is_monotonic_to({0.8, 0.0}));
  EXPECT_FALSE(folds.is_monotonic_to({0.83, 0.0}));
  EXPECT_FALSE(folds.undistorted({0.6, 0.0}));  // the maximum is 0.544
}

TEST(FrameRectifier, WithoutDistortionAndCorrectionFramesStay) {
  const DepthFrame frame = random_frame(1);
  EXPECT_EQ(FrameRectifier({camera, {}, {}, {}}).rectified(frame).depth, frame.depth);
}

TEST(FrameRectifier, APixelHasTheFactorOfItsPlaceAndDepth) {
  const DepthCorrection grid = random_correction(2);
  const DepthFrame frame = random_frame(3);
  const DepthFrame rectified = FrameRectifier({camera, {}, grid, {}}).rectified(frame);
  for (Index v = 0; v < camera.height; v += 7) {
    for (Index u = 0; u < camera.width; ++u) {
      const std::size_t i = std::size_t{v} * camera.width + u;
      EXPECT_NEAR(rectified.depth[i], frame.depth[i] * grid.factor(u, v, frame.depth[i]), 1e-5);
    }
  }
}

TEST(DepthCorrection, IsExactAtItsNodesAndHeldAtOtherDepths) {
  const DepthCorrection grid = random_correction(4);
  for (Index k = 0; k < grid.ranges; ++k) {
    EXPECT_NEAR(grid.factor(159.0 / 2, 119.0 / 3, grid.range(k)), grid.factors[grid.cell(k, 1, 2)],
                1e-6);
  }
  EXPECT_EQ(grid.factor(0, 0, 0.1), grid.factors[grid.cell(0, 0, 0)]);
  EXPECT_EQ(grid.factor(159, 119, 9.0), grid.factors[grid.cell(5, 3, 4)]);
}

TEST(FrameRectifier, ADistortedPlaneIsAPlaneAgain) {
  // 1/z = a x + b y + c at the true ray of every pixel.
  const Eigen::Vector3d plane(0.3, -0.2, 1.0);
  DepthFrame seen;
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const auto ray = lens.undistorted(camera.ray(u, v).head<2>());
      seen.depth.push_back(ray ? static_cast<float>(1.0 / plane.dot(ray->homogeneous())) : 0.0F);
    }
  }
  const DepthFrame rectified = FrameRectifier({camera, lens, {}, {}}).rectified(seen);
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const float z = rectified.depth[std::size_t{v} * camera.width + u];
      if (z == 0.0F) continue;
      // Half a pixel of the nearest neighbour.
      EXPECT_NEAR(z, 1.0 / plane.dot(camera.ray(u, v)), 0.004);
    }
  }
}

TEST(FrameRectifier, AColourCameraIsRegisteredToTheDepth) {
  // The colour of a pixel of the colour camera is its column; a wall at 1 m, 131 px per metre.
  CameraModel model{camera, {}, {}, ColorCamera{camera, {}, Eigen::Isometry3d::Identity()}};
  model.color->T_depth_color.translation().x() = 10.0 / 131.0;
  DepthFrame frame;
  frame.depth.assign(camera.pixels(), 1.0F);
  frame.colors = Colors::Zero(static_cast<Eigen::Index>(camera.pixels()), 3);
  for (Eigen::Index i = 0; i < frame.colors.rows(); ++i)
    frame.colors.row(i).setConstant(static_cast<std::uint8_t>(i % camera.width));
  const DepthFrame rectified = FrameRectifier(model).rectified(frame);
  EXPECT_EQ(rectified.colors(100, 0), 90);
  EXPECT_EQ(rectified.colors(5, 0), 0);
}

TEST(FrameRectifier, GivesTheSameBytesForAnyNumberOfThreads) {
  const FrameRectifier rectifier({camera, lens, random_correction(5), {}});
  const DepthFrame frame = random_frame(6);
  EXPECT_EQ(testing::with_threads(1, [&] { return rectifier.rectified(frame).depth; }),
            testing::with_threads(3, [&] { return rectifier.rectified(frame).depth; }));
}

TEST(FrameRectifier, RefusesImagesAndCorrectionsOfAnotherSize) {
  DepthFrame small;
  small.depth.assign(10, 1.0F);
  EXPECT_THROW(FrameRectifier({camera, {}, {}, {}}).rectified(small), InputError);
  DepthCorrection grid = random_correction(7);
  grid.width = 320;
  EXPECT_THROW(FrameRectifier({camera, {}, grid, {}}), InputError);
  grid = random_correction(7);
  grid.factors.front() = 0.0F;
  EXPECT_THROW(grid.validate(), InputError);
}

}  // namespace
}  // namespace symscene
