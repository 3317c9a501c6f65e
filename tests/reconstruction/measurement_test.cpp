#include "reconstruction/measurement.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "reconstruction/analytic_scenes.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/geometry.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

/// In frontal views at 1 m.
double weight_of(std::uint32_t packed) {
  return double{weight_of_root(packed & 255)} / Measurement::weight_units;
}

TEST(Measurement, HasTheNormalsOfANoisyPlane) {
  std::mt19937 random(3);
  const CameraIntrinsics camera{320, 240, 262.0, 262.0, 159.5, 119.5};
  for (const Eigen::Vector3d& tilt : {Eigen::Vector3d(0, 0, -1), Eigen::Vector3d(0.4, -0.5, -1)}) {
    const Eigen::Vector3d truth = tilt.normalized();
    DepthFrame frame = render({plane(truth, 1.0)}, camera, Eigen::Isometry3d::Identity());
    const DepthFrame exact = frame;
    for (float& z : frame.depth)
      z *= 1.0F + std::normal_distribution<float>(0, 1.4e-3F)(random) * z;
    const Measurement measurement = prepare_measurement(frame, camera, {});
    for (const SurfaceImage& level : measurement.pyramid) {
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      std::size_t with_normal = 0;
      for (const SurfacePixel& pixel : level.pixels) {
        if (pixel.nz == 0.0F) continue;
        EXPECT_NEAR(normal_of(pixel).norm(), 1.0, 1e-5);
        mean += normal_of(pixel);
        ++with_normal;
      }
      EXPECT_GT(with_normal, 8 * level.pixels.size() / 10);
      EXPECT_LT(angle_between(mean, truth), radians(0.7));
      EXPECT_GT(mean.norm() / static_cast<double>(with_normal), std::cos(radians(25.0)));
    }
    // The measured depths are fused, not the smoothed ones.
    for (std::size_t i = 0; i < camera.pixels(); ++i) {
      if (measurement.packed[i] == 0) continue;
      EXPECT_NEAR((measurement.packed[i] >> 16) * 1e-4, frame.depth[i], 6e-5);
    }
    double smoothed = 0.0, raw = 0.0;
    for (std::size_t i = 0; i < camera.pixels(); ++i) {
      smoothed +=
          std::pow(static_cast<double>(measurement.pyramid[0].pixels[i].depth - exact.depth[i]), 2);
      raw += std::pow(static_cast<double>(frame.depth[i] - exact.depth[i]), 2);
    }
    EXPECT_LT(smoothed, 0.6 * raw);
  }
}

TEST(Measurement, PlacesEveryLevelsPixelsOnTheSurface) {
  const Bodies bodies{plane(Eigen::Vector3d(0.3, -0.2, -1).normalized(), 0.8)};
  const Measurement measurement = prepare_measurement(
      render(bodies, small_camera(), Eigen::Isometry3d::Identity()), small_camera(), {});
  ASSERT_EQ(measurement.pyramid.size(), 3U);
  for (const SurfaceImage& level : measurement.pyramid) {
    for (Index v = 2; v + 2 < level.camera.height; ++v) {
      for (Index u = 2; u + 2 < level.camera.width; ++u) {
        const double truth = depth_at(bodies, level.camera, Eigen::Isometry3d::Identity(), u, v);
        EXPECT_NEAR(level.pixels[std::size_t{v} * level.camera.width + u].depth, truth, 5e-4);
      }
    }
  }
}

/// The frame with a hole at every third pixel along rows and columns.
DepthFrame with_grid_of_holes(DepthFrame frame, const CameraIntrinsics& camera) {
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      if (u % 3 == 1 || v % 3 == 1) frame.depth[std::size_t{v} * camera.width + u] = 0.0F;
    }
  }
  return frame;
}

TEST(Measurement, OfAGridOfHolesHasNormalsWhereTheWholeImageHas) {
  const CameraIntrinsics camera{320, 240, 280.0, 282.0, 159.1, 120.1};
  const DepthFrame whole = render(tabletop(), camera, around_table(0));
  const DepthFrame holed = with_grid_of_holes(whole, camera);
  const Measurement all = prepare_measurement(whole, camera, {});
  const Measurement some = prepare_measurement(holed, camera, {});
  EXPECT_GT(some.measured, 8 * all.measured / 10);
  std::size_t measured = 0, fused = 0;
  for (std::size_t i = 0; i < camera.pixels(); ++i) {
    EXPECT_TRUE(holed.depth[i] > 0.0F || some.packed[i] == 0) << "a hole is not fused";
    measured += holed.depth[i] > 0.0F && all.packed[i] != 0 ? 1 : 0;
    fused += some.packed[i] != 0 ? 1 : 0;
  }
  EXPECT_GT(fused, 8 * measured / 10);
}

TEST(Measurement, BridgesNoHoleBetweenTwoSurfaces) {
  const CameraIntrinsics camera = small_camera();
  DepthFrame frame = flat_frame(camera, 1.0F);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (i % 160 >= 80) frame.depth[i] = i % 160 == 80 ? 0.0F : 0.8F;
  }
  const Measurement measurement = prepare_measurement(frame, camera, {});
  for (std::size_t v = 0; v < 120; ++v) {
    EXPECT_EQ(measurement.pyramid[0].pixels[v * 160 + 80].depth, 0.0F);
  }
}

/// Two frontal planes that meet in the middle of the image.
DepthFrame step_frame(float left, float right) {
  DepthFrame frame = flat_frame(small_camera(), left);
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (i % 160 >= 80) frame.depth[i] = right;
  }
  return frame;
}

TEST(Measurement, FusesPixelsBesideEdgesWithTheirOwnSurface) {
  const DepthFrame frame = step_frame(1.0F, 0.8F);
  const Measurement measurement = prepare_measurement(frame, small_camera(), {});
  for (std::size_t v = 10; v < 110; ++v) {
    for (const std::size_t u : {70U, 79U, 80U, 90U}) {
      const std::uint32_t packed = measurement.packed[v * 160 + u];
      EXPECT_NEAR((packed >> 16) * 1e-4, frame.depth[v * 160 + u], 6e-5);
      EXPECT_NEAR(((packed >> 8) & 255) / 255.0, 1.0, 0.02) << "seen from the front";
    }
    for (const std::size_t u : {79U, 80U})
      EXPECT_EQ(measurement.pyramid[0].pixels[v * 160 + u].nz, 0.0F) << "not used for tracking";
  }
}

TEST(Measurement, GivesNoWeightToDepthsBetweenTwoSurfaces) {
  DepthFrame frame = step_frame(1.0F, 0.8F);
  for (std::size_t v = 0; v < 120; ++v) frame.depth[v * 160 + 80] = 0.86F;
  const Measurement measurement = prepare_measurement(frame, small_camera(), {});
  for (std::size_t v = 10; v < 110; ++v) EXPECT_EQ(measurement.packed[v * 160 + 80], 0U);
}

TEST(Measurement, GivesNoWeightToEdgesWhoseNoiseHidesTheirShape) {
  const double depth = 2.0;
  MeasurementOptions options;
  ASSERT_GT(options.deviation(depth), options.max_edge_deviation);
  const Measurement measurement =
      prepare_measurement(step_frame(2.0F, 1.5F), small_camera(), options);
  for (std::size_t v = 10; v < 110; ++v) {
    EXPECT_EQ(measurement.packed[v * 160 + 79], 0U);
    EXPECT_NE(measurement.packed[v * 160 + 70], 0U);
  }
}

TEST(Measurement, FusesTheEdgeOfABoxSeenAtAFlatAngle) {
  const double tilt = radians(75.0);
  const Bodies corner{
      plane(Eigen::Vector3d(std::sin(tilt), 0, -std::cos(tilt)), 0.7 * std::cos(tilt)),
      plane(Eigen::Vector3d(-std::sin(0.3), 0, -std::cos(0.3)), 0.7 * std::cos(0.3))};
  const DepthFrame frame = render(corner, small_camera(), Eigen::Isometry3d::Identity());
  const Measurement measurement = prepare_measurement(frame, small_camera(), {});
  for (std::size_t v = 10; v < 110; ++v) {
    for (std::size_t u = 70; u < 90; ++u) EXPECT_NE(measurement.packed[v * 160 + u], 0U) << u;
  }
}

TEST(Measurement, WeightsPixelsLessFarAwayAndAtAnAngle) {
  const auto middle = [](double depth, double tilt) {
    const Eigen::Vector3d normal(std::sin(tilt), 0, -std::cos(tilt));
    const Bodies wall{plane(normal, depth * std::cos(tilt))};
    const Measurement measurement = prepare_measurement(
        render(wall, small_camera(), Eigen::Isometry3d::Identity()), small_camera(), {});
    return weight_of(measurement.packed[60 * 160 + 79]);
  };
  EXPECT_NEAR(middle(1.0, 0.0), 1.0, 0.07);  // the unit
  for (const double tilt : {0.0, 0.5, 1.0}) {
    EXPECT_GT(middle(0.6, tilt), middle(0.7, tilt));
    EXPECT_GT(middle(0.7, tilt), middle(1.0, tilt));
    EXPECT_GT(middle(0.6, tilt), middle(0.6, tilt + 0.2));
  }
  EXPECT_GT(middle(2.9, 0.0), 0.0);
  EXPECT_EQ(middle(0.6, radians(86.0)), 0.0);
}

TEST(Measurement, IgnoresDepthsOutOfRange) {
  for (const float depth :
       {0.0F, -1.0F, 0.15F, 6.1F, 1e30F, -1e30F, 1e-42F, std::numeric_limits<float>::quiet_NaN(),
        std::numeric_limits<float>::infinity()}) {
    const DepthFrame frame = flat_frame(small_camera(), depth);
    const Measurement measurement = prepare_measurement(frame, small_camera(), {});
    EXPECT_EQ(measurement.measured, 0U) << depth;
    for (const std::uint32_t packed : measurement.packed) ASSERT_EQ(packed, 0U) << depth;
    for (const SurfaceImage& level : measurement.pyramid) {
      for (const SurfacePixel& pixel : level.pixels) ASSERT_EQ(pixel.depth, 0.0F) << depth;
    }
  }
}

TEST(Measurement, SpeckleDoesNotChangeNormals) {
  DepthFrame frame = flat_frame(small_camera(), 0.8F);
  for (std::size_t i = 0; i < frame.depth.size(); i += 211) {
    frame.depth[i] = i % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : 0.4F;
  }
  const Measurement measurement = prepare_measurement(frame, small_camera(), {});
  EXPECT_GT(measurement.measured, 8 * frame.depth.size() / 10);
  for (const SurfacePixel& pixel : measurement.pyramid[0].pixels) {
    ASSERT_TRUE(std::isfinite(pixel.depth));
    if (pixel.nz != 0.0F) {
      EXPECT_LT(pixel.nz, -0.99F);
    }
  }
}

TEST(Measurement, AcceptsImagesOfAnySizeFromEightPixels) {
  const std::array<std::pair<Index, Index>, 10> sizes{{{161, 121},
                                                       {9, 9},
                                                       {8, 8},
                                                       {8, 200},
                                                       {200, 8},
                                                       {15, 17},
                                                       {33, 31},
                                                       {641, 15},
                                                       {641, 17},
                                                       {1001, 401}}};
  for (const auto& [width, height] : sizes) {
    const CameraIntrinsics camera{
        width, height, 0.8 * width, 0.8 * width, 0.5 * (width - 1), 0.5 * (height - 1)};
    const DepthFrame frame = flat_frame(camera, 1.0F);
    const Measurement measurement = prepare_measurement(frame, camera, {});
    EXPECT_EQ(measurement.packed.size(), camera.pixels() + 1);
    EXPECT_EQ(measurement.packed.back(), 0U);
    ASSERT_FALSE(measurement.pyramid.empty());
    ASSERT_LE(measurement.pyramid.size(), 3U);
    for (const SurfaceImage& level : measurement.pyramid) {
      ASSERT_EQ(level.pixels.size(), level.camera.pixels());
      EXPECT_GE(level.camera.width, 4U);
      EXPECT_GE(level.camera.height, 4U);
    }
    EXPECT_GT(measurement.measured, 0U) << width << "x" << height;
    const auto fused =
        camera.pixels() - static_cast<std::size_t>(std::count(measurement.packed.begin(),
                                                              measurement.packed.end() - 1, 0U));
    EXPECT_GE(fused, measurement.measured) << width << "x" << height;
  }
}

TEST(Measurement, RefusesImagesOfAnotherSize) {
  const CameraIntrinsics camera = small_camera();
  EXPECT_THROW(prepare_measurement({}, camera, {}), InputError);
  DepthFrame frame = flat_frame(camera, 1.0F);
  frame.depth.pop_back();
  EXPECT_THROW(prepare_measurement(frame, camera, {}), InputError);
  const auto refused = [](auto&& change) {
    CameraIntrinsics bad = small_camera();
    change(bad);
    EXPECT_THROW(prepare_measurement(flat_frame(bad, 1.0F), bad, {}), InputError);
  };
  refused([](auto& c) { c.width = 7; });
  refused([](auto& c) { c.height = 0; });
  refused([](auto& c) { c.fx = 0.0; });
  refused([](auto& c) { c.fy = -100.0; });
  refused([](auto& c) { c.cx = std::numeric_limits<double>::quiet_NaN(); });
  refused([](auto& c) { c.fx = std::numeric_limits<double>::infinity(); });
}

TEST(Measurement, IsTheSameForAnyNumberOfThreads) {
  const DepthFrame frame = render(tabletop(), small_camera(), around_table(0.0));
  const auto run = [&] { return prepare_measurement(frame, small_camera(), {}); };
  const Measurement one = with_threads(1, run), two = with_threads(2, run);
  EXPECT_EQ(one.packed, two.packed);
  ASSERT_EQ(one.pyramid.size(), two.pyramid.size());
  for (std::size_t k = 0; k < one.pyramid.size(); ++k) {
    EXPECT_TRUE(same(one.pyramid[k], two.pyramid[k]));
  }
}

}  // namespace
}  // namespace symscene
