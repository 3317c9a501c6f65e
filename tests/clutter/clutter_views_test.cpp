#include "symscene/clutter/clutter_views.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "clutter_scenes.hpp"
#include "core/random.hpp"
#include "symscene/physics/physics_world.hpp"

namespace symscene {
namespace {

constexpr Index small_width = 64, small_height = 48;
const CameraIntrinsics small_camera{small_width, small_height, 54.0, 54.0, 32.0, 24.0};

TEST(ClutterViews, CamerasLookAtTheTargetFromTheirDistance) {
  for (const int views : {1, 6}) {
    const auto poses = clutter_view_poses(views);
    ASSERT_EQ(poses.size(), views);
    for (const Eigen::Isometry3d& pose : poses) {
      const Eigen::Vector3d target = pose.inverse() * Eigen::Vector3d(0.15, 0.15, 0.10);
      EXPECT_NEAR((target - Eigen::Vector3d(0, 0, 0.6)).norm(), 0.0, 1e-9);
      EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-9);
      EXPECT_LT(pose.linear()(2, 1), 0.0) << "the image's y axis points down";
      EXPECT_NEAR(pose.linear()(2, 0), 0.0, 1e-9) << "the image's x axis is level";
    }
  }
  EXPECT_LT(clutter_view_poses(1).front().translation().y(), -0.3);
}

TEST(ClutterNoise, TheScaleHasTheMeanAndDeviationOfTheGammaDistribution) {
  ClutterNoiseOptions options;
  options.grain_probability = 0.0;
  const std::vector<float> exact{0.5F};
  const CameraIntrinsics one{1, 1, 1.0, 1.0, 0.0, 0.0};
  double sum = 0.0, squares = 0.0;
  constexpr int samples = 4000;
  for (int i = 0; i < samples; ++i) {
    const double scale =
        with_clutter_noise(exact, one, options, Random(1, static_cast<std::uint64_t>(i)))[0] / 0.5;
    sum += scale;
    squares += (scale - 1.0) * (scale - 1.0);
  }
  EXPECT_NEAR(sum / samples, 1.0, 0.002);
  EXPECT_NEAR(std::sqrt(squares / samples), std::sqrt(0.001), 0.0015);
}

TEST(ClutterNoise, AnImageHasOneScaleAndNothingStaysUnmeasured) {
  ClutterNoiseOptions options;
  options.grain_probability = 0.0;
  std::vector<float> exact(small_camera.pixels(), 1.0F);
  exact[5] = 0.0F;
  const std::vector<float> noisy = with_clutter_noise(exact, small_camera, options, Random(3));
  EXPECT_EQ(noisy[5], 0.0F);
  EXPECT_NE(noisy[0], 1.0F);
  for (std::size_t i = 6; i < noisy.size(); ++i) EXPECT_EQ(noisy[i], noisy[0]);
}

TEST(ClutterNoise, GrainIsSmoothBetweenTheNodesOfItsGrid) {
  ClutterNoiseOptions options;
  options.grain_probability = 1.0;
  const std::vector<float> exact(small_camera.pixels(), 1.0F);
  const std::vector<float> noisy = with_clutter_noise(exact, small_camera, options, Random(4));
  double mean = 0.0, deviation = 0.0, step = 0.0;
  for (const float depth : noisy)
    mean += static_cast<double>(depth) / static_cast<double>(noisy.size());
  for (Index v = 0; v < small_height; ++v) {
    for (Index u = 0; u + 1 < small_width; ++u) {
      const double here = noisy[std::size_t{v} * small_width + u];
      const double next = noisy[std::size_t{v} * small_width + u + 1];
      deviation += (here - mean) * (here - mean);
      step += (next - here) * (next - here);
    }
  }
  const double pixels = small_height * (small_width - 1);
  // Interpolation lowers the deviation of 5 mm; neighbours differ by a fraction of it.
  EXPECT_NEAR(std::sqrt(deviation / pixels), 0.0035, 0.0008);
  EXPECT_LT(std::sqrt(step / pixels), 0.0025);
}

class ClutterViewsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_physics()) GTEST_SKIP() << "skipped: this build has no physics";
  }
  const std::vector<ClutterObject> objects_ = box_objects();
};

TEST_F(ClutterViewsTest, DepthIsThatOfTheTableAndTheObjects) {
  const ClutterWorld world(objects_, ClutterKind::packed, 1, 4);
  ClutterNoiseOptions exact;
  exact.enabled = false;
  const ClutterView view = clutter_views(world, 1, exact, 1).front();
  const CameraIntrinsics camera = clutter_camera();
  const std::size_t item = world.present().front();
  std::size_t above = 0, below = 0;
  for (Index v = 0; v < camera.height; ++v) {
    for (Index u = 0; u < camera.width; ++u) {
      const double depth = view.frame.depth[std::size_t{v} * camera.width + u];
      if (depth == 0.0) continue;
      const Eigen::Vector3d point = view.T_world_camera * (depth * camera.ray(u, v));
      below += point.z() < clutter::table_height - 1e-4 ? 1 : 0;
      if (point.z() < clutter::table_height + 1e-3) continue;
      ++above;
      ASSERT_LT((point - world.pose(item).translation()).norm(), 0.1);
    }
  }
  EXPECT_EQ(below, 0);
  EXPECT_GT(above, 500);
}

TEST_F(ClutterViewsTest, NothingHidesASingleObjectAndObjectsBehindOthersAreHidden) {
  const ClutterWorld alone(objects_, ClutterKind::packed, 1, 4);
  EXPECT_NEAR(clutter_occlusion(alone, 1).front(), 0.0, 1e-9);
  double most = 0.0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    const ClutterWorld world(objects_, ClutterKind::packed, 5, seed);
    for (const double occlusion : clutter_occlusion(world, 1)) {
      EXPECT_GE(occlusion, 0.0);
      EXPECT_LE(occlusion, 1.0);
      most = std::max(most, occlusion);
    }
  }
  EXPECT_GT(most, 0.1);
}

}  // namespace
}  // namespace symscene
