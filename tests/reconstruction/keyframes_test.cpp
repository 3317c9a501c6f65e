#include "reconstruction/keyframes.hpp"

#include <gtest/gtest.h>

#include "reconstruction/analytic_scenes.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

Measurement seen_from(const Eigen::Isometry3d& pose) {
  return prepare_measurement(render(tabletop(), small_camera(), pose), small_camera(), {});
}

TEST(Keyframes, RankViewsBySimilarity) {
  Keyframes keyframes({.keyframe_distance = 0.1, .keyframe_angle = 0.2});
  for (int k = 0; k < 12; ++k) {
    keyframes.add(seen_from(around_table(0.5 * k)), around_table(0.5 * k));
  }
  ASSERT_EQ(keyframes.size(), 12U);
  for (int k = 0; k < 12; ++k) {
    const auto ranked = keyframes.most_similar(seen_from(around_table(0.5 * k + 0.06)), 3);
    ASSERT_EQ(ranked.size(), 3U);
    EXPECT_TRUE(ranked[0].isApprox(around_table(0.5 * k))) << k;
  }
}

TEST(Keyframes, AreKeptApartByDistanceOrAngle) {
  Keyframes keyframes({.keyframe_distance = 0.15, .keyframe_angle = 0.26});
  const Measurement any = seen_from(around_table(0.0));
  const auto add = [&](double x, double turn) {
    keyframes.add(any, motion({0, 0, turn}, {x, 0, 0}));
    return keyframes.size();
  };
  EXPECT_EQ(add(0.0, 0.0), 1U);
  EXPECT_EQ(add(0.14, 0.25), 1U);
  EXPECT_EQ(add(0.16, 0.0), 2U);
  EXPECT_EQ(add(0.08, 0.27), 3U);
  EXPECT_EQ(add(0.08, 0.27), 3U);
  for (int k = 0; k < 1000; ++k) add(0.3 * k / 1000.0, 0.0);
  EXPECT_LE(keyframes.size(), 5U);
}

TEST(Keyframes, ReturnAtMostTheRequestedNumber) {
  Keyframes keyframes({.keyframe_distance = 0.1, .keyframe_angle = 0.1});
  const Measurement any = seen_from(around_table(0.0));
  EXPECT_TRUE(keyframes.most_similar(any, 4).empty());
  for (double x = 0.0; x < 6.0; x += 1.0) {
    keyframes.add(any, motion({0, 0, 0}, {x, 0, 0}));
  }
  EXPECT_EQ(keyframes.most_similar(any, 4).size(), 4U);
  EXPECT_EQ(keyframes.most_similar(any, 40).size(), 6U);
  // Equally similar ones in the order in which they were added.
  EXPECT_EQ(keyframes.most_similar(any, 4)[3].translation().x(), 3.0);
}

TEST(Keyframes, AcceptImagesWithoutDepthAndTinyImages) {
  Keyframes keyframes({.keyframe_distance = 0.1, .keyframe_angle = 0.1});
  const DepthFrame black = flat_frame(small_camera(), 0.0F);
  const Measurement nothing = prepare_measurement(black, small_camera(), {});
  keyframes.add(nothing, Eigen::Isometry3d::Identity());
  EXPECT_EQ(keyframes.most_similar(nothing, 1).size(), 1U);
  const CameraIntrinsics tiny{8, 8, 6.0, 6.0, 3.5, 3.5};
  const DepthFrame frame = flat_frame(tiny, 1.0F);
  EXPECT_EQ(keyframes.most_similar(prepare_measurement(frame, tiny, {}), 1).size(), 1U);
}

}  // namespace
}  // namespace symscene
