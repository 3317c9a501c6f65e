#include "symscene/stitching/stitching.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "reconstruction/measurement.hpp"
#include "reconstruction/pose_fit.hpp"
#include "stitching/pair_pose.hpp"
#include "stitching/textured_scene.hpp"
#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace testing;

class Stitching : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_feature_matcher()) GTEST_SKIP() << "this build has no OpenCV";
  }
};

PairPose pair_pose(const DepthFrame& first, const DepthFrame& second) {
  const StitchingOptions options;
  const auto features = [&](const DepthFrame& frame) {
    return find_features(frame, camera, options.features, options.measurement);
  };
  const auto surface = [&](const DepthFrame& frame) {
    return prepare_measurement(frame, camera, options.measurement).pyramid[1];
  };
  return find_pair_pose({features(first), surface(first)}, {features(second), surface(second)},
                        camera, options);
}

/// The largest error of the placed frames relative to the first of them.
PoseError worst_error(const StitchingResult& result, std::span<const Eigen::Isometry3d> truth) {
  PoseError worst;
  std::optional<std::size_t> root;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!result.frames[i].T_world_camera) continue;
    if (!root) root = i;
    const PoseError error = pose_error(
        result.frames[*root].T_world_camera->inverse() * *result.frames[i].T_world_camera,
        truth[*root].inverse() * truth[i]);
    worst.distance = std::max(worst.distance, error.distance);
    worst.angle = std::max(worst.angle, error.angle);
  }
  return worst;
}

TEST_F(Stitching, FindsThePoseOfAPair) {
  for (const double angle : {20.0, 30.0, 40.0}) {
    const Photographs two = photograph_table({0.0, angle});
    const PairPose pair = pair_pose(two.frames[0], two.frames[1]);
    ASSERT_EQ(pair.status, PairStatus::accepted)
        << angle << " degrees: " << to_string(pair.status) << ", " << pair.matches << " matches, "
        << pair.inliers.size() << " inliers, " << pair.depth.agreement;
    const PoseError error = pose_error(pair.T_first_second, two.truth[0].inverse() * two.truth[1]);
    EXPECT_LT(error.distance, 0.01) << angle << " degrees apart";
    EXPECT_LT(degrees(error.angle), 1.0) << angle << " degrees apart";
  }
}

TEST_F(Stitching, FindsThePoseOfAPairFromOppositeSides) {
  const Photographs two = photograph_table({0.0, 170.0});
  const PairPose pair = pair_pose(two.frames[0], two.frames[1]);
  ASSERT_EQ(pair.status, PairStatus::accepted);
  EXPECT_LT(pose_error(pair.T_first_second, two.truth[0].inverse() * two.truth[1]).distance, 0.02);
}

TEST_F(Stitching, FindsNoPoseBetweenTwoTables) {
  const Photographs here = photograph_table({0.0}),
                    there = photograph_table({0.0}, Look::printed, 2);
  EXPECT_NE(pair_pose(here.frames[0], there.frames[0]).status, PairStatus::accepted);
}

TEST_F(Stitching, RejectsAPoseThatContradictsTheDepth) {
  const Photographs two = photograph_table({0.0, 20.0});
  const SurfaceImage first = prepare_measurement(two.frames[0], camera, {}).pyramid[1];
  const SurfaceImage second = prepare_measurement(two.frames[1], camera, {}).pyramid[1];
  const Eigen::Isometry3d right = two.truth[0].inverse() * two.truth[1];
  Eigen::Isometry3d wrong = right;
  wrong.pretranslate(Eigen::Vector3d(0.0, 0.0, -0.2));
  const DepthNoise noise{.floor = 0.007F, .moved = 0.0F, .fixed = 1.425e-3F};
  EXPECT_GT(depth_fit(second, first, right, noise).agreement(), 0.95);
  EXPECT_LT(depth_fit(second, first, wrong, noise).agreement(), 0.5);
}

TEST_F(Stitching, PlacesFramesAroundATable) {
  const Photographs table = photograph_table({0, 25, 50, 75, 100, 125});
  const StitchingResult result = stitch_frames(table.frames, camera);
  EXPECT_EQ(result.placed, table.frames.size());
  EXPECT_EQ(result.pairs.size(), 15U);
  const PoseError worst = worst_error(result, table.truth);
  EXPECT_LT(worst.distance, 0.005);
  EXPECT_LT(degrees(worst.angle), 0.4);
}

/// A sweep in steps of 9°, of which the frames from the middle on have no colours.
Photographs half_colored_sweep() {
  Photographs sweep = photograph_table({0, 9, 18, 27, 36, 45, 54});
  for (std::size_t i = 4; i < sweep.frames.size(); ++i) sweep.frames[i].colors.resize(0, 3);
  return sweep;
}

TEST_F(Stitching, ClosesTheGapsOfASweepByDepth) {
  const Photographs sweep = half_colored_sweep();
  const StitchingResult result = stitch_sweep(sweep.frames, camera);
  EXPECT_EQ(result.placed, sweep.frames.size());
  const auto tracked = std::count_if(
      result.pairs.begin(), result.pairs.end(),
      [](const StitchedPair& pair) { return pair.pose.status == PairStatus::tracked; });
  EXPECT_EQ(tracked, 3);
  const PoseError worst = worst_error(result, sweep.truth);
  EXPECT_LT(worst.distance, 0.005);
  EXPECT_LT(degrees(worst.angle), 0.4);
}

TEST_F(Stitching, LeavesAGapThatNoPoseCloses) {
  Photographs sweep = half_colored_sweep();
  const Photographs other = photograph_table({180, 189, 198});
  for (std::size_t i = 4; i < 7; ++i) {
    sweep.frames[i].depth = other.frames[i - 4].depth;
    for (float& depth : sweep.frames[i].depth) depth *= 1.5F;
  }
  EXPECT_LE(stitch_sweep(sweep.frames, camera).placed, 4U);
}

TEST_F(Stitching, ClosesGapsToTheSameBitsForAnyNumberOfThreads) {
  const Photographs sweep = half_colored_sweep();
  const auto with = [&](std::size_t threads) {
    return with_threads(threads, [&] { return stitch_sweep(sweep.frames, camera); });
  };
  const StitchingResult one = with(1), two = with(2);
  for (std::size_t i = 0; i < sweep.frames.size(); ++i) {
    ASSERT_TRUE(one.frames[i].T_world_camera && two.frames[i].T_world_camera) << i;
    EXPECT_EQ(one.frames[i].T_world_camera->matrix(), two.frames[i].T_world_camera->matrix());
  }
}

TEST_F(Stitching, DoesNotDependOnTheOrderOfFrames) {
  const Photographs table = photograph_table({0, 25, 50, 75});
  Photographs shuffled;
  for (const std::size_t i : {2U, 0U, 3U, 1U}) {
    shuffled.frames.push_back(table.frames[i]);
    shuffled.truth.push_back(table.truth[i]);
  }
  const StitchingResult result = stitch_frames(shuffled.frames, camera);
  EXPECT_EQ(result.placed, 4U);
  EXPECT_LT(worst_error(result, shuffled.truth).distance, 0.005);
}

TEST_F(Stitching, NamesTheFrameOfAnotherScene) {
  Photographs table = photograph_table({0, 10, 25});
  table.frames[1] = photograph_table({10}, Look::printed, 2).frames.front();
  const StitchingResult result = stitch_frames(table.frames, camera);
  EXPECT_EQ(result.placed, 2U);
  EXPECT_FALSE(result.frames[1].T_world_camera);
  EXPECT_STREQ(result.frames[1].reason, "no surface in common with the other frames");
  EXPECT_STREQ(result.frames[0].reason, "");
}

TEST_F(Stitching, ReportsFramesWithoutTexture) {
  Photographs blank = photograph_table({0, 25}, Look::plain);
  for (DepthFrame& frame : blank.frames) frame.colors.setConstant(128);
  const StitchingResult result = stitch_frames(blank.frames, camera);
  EXPECT_EQ(result.placed, 0U);
  for (const StitchedFrame& frame : result.frames) {
    EXPECT_STREQ(frame.reason, "too little texture where depth is known");
  }
}

TEST_F(Stitching, GivesTheSameBitsForAnyNumberOfThreads) {
  const Photographs table = photograph_table({0, 30, 60});
  const auto with = [&](std::size_t threads) {
    return with_threads(threads, [&] { return stitch_frames(table.frames, camera); });
  };
  const StitchingResult one = with(1), four = with(4);
  ASSERT_EQ(one.placed, 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(one.frames[i].T_world_camera->matrix(), four.frames[i].T_world_camera->matrix());
    EXPECT_EQ(one.pairs[i].pose.inliers.size(), four.pairs[i].pose.inliers.size());
  }
}

TEST_F(Stitching, RefusesFramesOfAnotherSize) {
  DepthFrame frame{0.0, std::vector<float>(camera.pixels(), 1.0F), {}};
  EXPECT_THROW(find_features(frame, camera, {}, {}), InputError);
  frame.colors.setZero(10, 3);
  EXPECT_THROW(find_features(frame, camera, {}, {}), InputError);
}

TEST_F(Stitching, OfNoFramesPlacesNone) { EXPECT_EQ(stitch_frames({}, camera).placed, 0U); }

TEST(WithoutOpenCv, FeaturesAreRefusedInOneSentence) {
  if (has_feature_matcher()) GTEST_SKIP() << "this build has OpenCV";
  DepthFrame frame{0.0, std::vector<float>(camera.pixels(), 1.0F), {}};
  frame.colors.setZero(static_cast<Eigen::Index>(camera.pixels()), 3);
  EXPECT_THROW(find_features(frame, camera, {}, {}), InputError);
}

}  // namespace
}  // namespace symscene
