#include "reconstruction/range_options.hpp"

#include <gtest/gtest.h>

#include "reconstruction/analytic_scenes.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

TEST(RangeOptions, NearDepthIsThatOfTheNearestTenthOfTheMeasuredPixels) {
  const CameraIntrinsics camera = small_camera();
  DepthFrame frame = flat_frame(camera, 4.0F);
  const std::size_t row = camera.width;
  std::fill_n(frame.depth.begin(), 40 * row, 0.0F);
  std::fill_n(frame.depth.begin() + static_cast<std::ptrdiff_t>(60 * row), 20 * row, 1.0F);
  EXPECT_NEAR(near_depth(prepare_measurement(frame, camera, {})), 1.0, 1e-3);
  EXPECT_NEAR(near_depth(prepare_measurement(flat_frame(camera, 4.0F), camera, {})), 4.0, 1e-3);
  EXPECT_EQ(near_depth(prepare_measurement(flat_frame(camera, 0.0F), camera, {})), 0.0);
}

TEST(RangeOptions, AreTheGivenOnesOfATableAndGrowWithTheNoiseOfARoom) {
  const ReconstructionOptions given;
  for (const double near : {0.0, 0.3, 1.0, 2.0}) {
    const ReconstructionOptions fitted = fitted_to_depth(given, near);
    EXPECT_EQ(fitted.tsdf.voxel_size, given.tsdf.voxel_size);
    EXPECT_EQ(fitted.tsdf.max_truncation, given.tsdf.max_truncation);
    EXPECT_EQ(fitted.occupancy.free_margin, given.occupancy.free_margin);
  }
  double last = given.tsdf.voxel_size;
  for (const double near : {2.5, 3.0, 4.0, 5.9}) {
    const ReconstructionOptions fitted = fitted_to_depth(given, near);
    EXPECT_GT(fitted.tsdf.voxel_size, last);
    EXPECT_GE(fitted.tsdf.max_truncation, 2.9 * given.measurement.deviation(near));
    EXPECT_GE(fitted.occupancy.free_margin, given.measurement.deviation(near));
    EXPECT_NO_THROW(fitted.validate());
    last = fitted.tsdf.voxel_size;
  }
}

TEST(RangeOptions, KeepLargeVoxelsAndThoseThatAreAskedFor) {
  ReconstructionOptions given;
  given.tsdf.voxel_sigmas = 0.0;
  EXPECT_EQ(fitted_to_depth(given, 5.0).tsdf.voxel_size, given.tsdf.voxel_size);
  given.tsdf = {.voxel_size = 0.03, .voxel_sigmas = 0.4, .truncation = 0.1, .max_truncation = 0.2};
  EXPECT_EQ(fitted_to_depth(given, 5.0).tsdf.voxel_size, 0.03);
}

TEST(RangeOptions, AWallAt4MetresIsFusedInVoxelsOfItsNoise) {
  Reconstruction reconstruction(small_camera());
  const DepthFrame frame = flat_frame(small_camera(), 4.0F);
  EXPECT_TRUE(reconstruction.add(frame).fused);
  EXPECT_NEAR(reconstruction.voxel_size(), 0.4 * 1.425e-3 * 16.0, 1e-5);
  const TriangleMesh surface = reconstruction.surface();
  ASSERT_GT(surface.vertices.rows(), 1000);
  EXPECT_LT((surface.vertices.col(2).array() - 4.0F).abs().maxCoeff(), 2e-3F);
}

}  // namespace
}  // namespace symscene
