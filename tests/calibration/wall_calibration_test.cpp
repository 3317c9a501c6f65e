#include <gtest/gtest.h>

#include "calibration/simulated_walls.hpp"
#include "symscene/calibration/depth_calibration.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/frame_rectifier.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace calibration_test;

constexpr double noise = 1.4e-3;
const DepthCorrectionOptions small_grid{10, 8, 5, 4, 0.05, 2.0};

CameraErrorOptions two_percent(std::uint64_t pattern) {
  CameraErrorOptions options;
  options.depth_bias = 0.02;
  options.bias_pattern = pattern;
  return options;
}

/// Root mean square and mean of the error of corrected depth, over depth, at a true depth.
Eigen::Vector2d corrected_error(const DepthCorrection& grid, const DepthBias& bias, double z) {
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (Index v = 4; v < grid.height; v += 8) {
    for (Index u = 4; u < grid.width; u += 8) {
      const double seen = z * bias.factor(u, v, z);
      const double error = seen * grid.factor(u, v, seen) / z - 1.0;
      sum += error, squares += error * error, ++count;
    }
  }
  return {std::sqrt(squares / count), sum / count};
}

WallCalibrator calibrator_of(const DepthBias& bias, int views, bool knows_planes) {
  WallCalibrator calibrator(small_camera(), small_grid);
  for (int i = 0; i < views; ++i) {
    const Plane wall = wall_of(i, views);
    const auto seed = static_cast<std::uint64_t>(i);
    calibrator.add(measured_wall(wall, small_camera(), bias, noise, seed),
                   knows_planes ? std::optional(wall) : std::nullopt);
  }
  return calibrator;
}

TEST(WallCalibrator, WithKnownPlanesDepthIsTrueAtAllRanges) {
  for (const std::uint64_t pattern : {1U, 2U, 3U}) {
    const DepthBias bias(two_percent(pattern), small_camera());
    const DepthCalibration found = calibrator_of(bias, 10, true).calibrate();
    EXPECT_TRUE(found.is_absolute);
    for (const double z : {0.6, 1.0, 1.5, 2.0})
      EXPECT_LT(corrected_error(found.correction, bias, z)[0], 0.002) << pattern << " at " << z;
  }
}

TEST(WallCalibrator, WithoutPlanesTheWarpOfAWallVanishes) {
  const DepthBias bias(two_percent(4), small_camera());
  const DepthCalibration found = calibrator_of(bias, 10, false).calibrate();
  EXPECT_FALSE(found.is_absolute);
  EXPECT_EQ(found.warnings.size(), 1U);
  // Other views than those that it was calibrated with.
  WallCalibrator check(small_camera(), small_grid);
  WallCalibrator raw(small_camera(), small_grid);
  for (int i = 0; i < 5; ++i) {
    const Plane wall = wall_at(0.7 + 0.3 * i, 0.1, -0.15);
    std::vector<float> depth = measured_wall(wall, small_camera(), bias, 0.0, 1);
    raw.add(depth);
    const CameraModel model{small_camera(), {}, found.correction, {}};
    check.add(FrameRectifier(model).rectified(DepthFrame{0.0, depth, {}}).depth);
  }
  EXPECT_LT(check.calibrate().error_before, 0.2 * raw.calibrate().error_before);
}

TEST(WallCalibrator, AnUnbiasedCameraStaysAsItIs) {
  const DepthBias none({}, small_camera());
  const DepthCalibration found = calibrator_of(none, 8, true).calibrate();
  for (const float factor : found.correction.factors) EXPECT_NEAR(factor, 1.0, 0.003);
}

TEST(WallCalibrator, WhatStandsBeforeTheWallIsLeftOut) {
  const DepthBias bias(two_percent(5), small_camera());
  WallCalibrator calibrator(small_camera(), small_grid);
  for (int i = 0; i < 8; ++i) {
    const Plane wall = wall_of(i, 8);
    std::vector<float> depth = measured_wall(wall, small_camera(), bias, noise, 7);
    for (Index v = 70; v < 120; ++v) {
      for (Index u = 20; u < 90; ++u) depth[v * 160 + u] *= 0.85F;  // a cupboard
    }
    calibrator.add(depth, wall);
  }
  const DepthCalibration found = calibrator.calibrate();
  EXPECT_LT(corrected_error(found.correction, bias, 1.2)[0], 0.003);
}

TEST(WallCalibrator, TellsWhichCellsWereNotMeasured) {
  const DepthBias bias(two_percent(6), small_camera());
  WallCalibrator calibrator(small_camera(), small_grid);
  for (int i = 0; i < 6; ++i) {
    const Plane wall = wall_of(i, 6);
    std::vector<float> depth = measured_wall(wall, small_camera(), bias, noise, 7);
    for (std::size_t k = 0; k < depth.size(); ++k) depth[k] = k % 160 < 48 ? 0.0F : depth[k];
    calibrator.add(depth, wall);
  }
  const DepthCorrection grid = calibrator.calibrate().correction;
  for (Index k = 0; k < grid.ranges; ++k) {
    EXPECT_EQ(grid.measured[grid.cell(k, 4, 0)], 0);
    // It continues its neighbours.
    EXPECT_NEAR(grid.factors[grid.cell(k, 4, 0)], grid.factors[grid.cell(k, 4, 3)], 0.02);
  }
  EXPECT_EQ(grid.measured[grid.cell(2, 4, 7)], 1);
}

TEST(WallCalibrator, RefusesTooFewViewsAndOneDistanceOnly) {
  const DepthBias bias(two_percent(1), small_camera());
  EXPECT_THROW(calibrator_of(bias, 2, false).calibrate(), InputError);
  WallCalibrator calibrator(small_camera(), small_grid);
  for (int i = 0; i < 6; ++i)
    calibrator.add(measured_wall(wall_at(1.0, 0.05 * i, 0.0), small_camera(), bias, noise, 1));
  try {
    calibrator.calibrate();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.expected().find("several distances"), std::string::npos);
  }
}

TEST(WallCalibrator, ImagesWithoutAWallAreNamed) {
  const DepthBias bias(two_percent(1), small_camera());
  WallCalibrator calibrator = calibrator_of(bias, 5, false);
  std::vector<float> clutter(small_camera().pixels());
  Random random(9);
  for (std::size_t k = 0; k < clutter.size(); ++k)
    clutter[k] = static_cast<float>(
        0.5 + 0.3 * static_cast<double>((k / 160 / 8 * 7 + k % 160 / 8 * 3) % 11));
  calibrator.add(clutter);
  const DepthCalibration found = calibrator.calibrate();
  ASSERT_EQ(found.views.size(), 6U);
  EXPECT_TRUE(found.views[0].used);
  EXPECT_FALSE(found.views[5].used);
  EXPECT_FALSE(found.views[5].reason.empty());
}

}  // namespace
}  // namespace symscene
