#include "proposals/merge.hpp"

#include <gtest/gtest.h>

#include "index_range.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

PointCloud hundred_points() {
  PointCloud cloud;
  cloud.positions = Points::Zero(200, 3);
  for (Index i = 0; i < 200; ++i) cloud.positions(i, 0) = 0.001F * static_cast<float>(i);
  return cloud;
}

TEST(Merge, KeepsTheMostConfidentPointsAndAllSymmetries) {
  const ReflectionPlane x{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()};
  const ReflectionPlane y{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY()};
  std::vector<RatedHypothesis> rated(3);
  rated[0] = {{testing::index_range(0, 100), {.symmetry = 0.1}, {}, x}, 0.5};
  rated[1] = {{testing::index_range(0, 99), {.symmetry = 0.2}, {}, y}, 0.9};
  rated[2] = {{testing::index_range(0, 60), {.symmetry = 0.0}, {}, x}, 0.4};
  const std::vector<MergedHypothesis> merged = merge_hypotheses(rated, hundred_points());
  ASSERT_EQ(merged.size(), 2U);
  EXPECT_EQ(merged[0].points, testing::index_range(0, 99));
  EXPECT_EQ(merged[0].confidence, 0.9);
  ASSERT_EQ(merged[0].planes.size(), 2U);
  EXPECT_EQ(merged[0].planes[0].plane.normal, x.normal);  // by ascending residual
  EXPECT_EQ(merged[0].planes[0].residual, 0.1);
  EXPECT_EQ(merged[1].planes.size(), 1U);
}

TEST(Merge, KeepsASymmetryOnce) {
  const ReflectionPlane plane{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY()};
  const ReflectionPlane nearly{{0.0, 0.002, 0.0}, -Eigen::Vector3d(0.02, 1.0, 0.0).normalized()};
  std::vector<RatedHypothesis> rated(2);
  rated[0] = {{testing::index_range(0, 100), {}, {}, plane}, 0.5};
  rated[1] = {{testing::index_range(0, 100), {}, {}, nearly}, 0.4};
  const std::vector<MergedHypothesis> merged = merge_hypotheses(rated, hundred_points());
  ASSERT_EQ(merged.size(), 1U);
  EXPECT_EQ(merged[0].planes.size(), 1U);
}

TEST(Merge, ComparesPointsByTheirOverlap) {
  EXPECT_TRUE(cover_same_points(testing::index_range(0, 100), testing::index_range(0, 100), 0.95));
  EXPECT_TRUE(cover_same_points(testing::index_range(0, 96), testing::index_range(0, 100), 0.95));
  EXPECT_TRUE(cover_same_points(testing::index_range(0, 100), testing::index_range(0, 96), 0.95));
  EXPECT_FALSE(cover_same_points(testing::index_range(0, 95), testing::index_range(0, 100),
                                 0.95));  // 0.95 is not more
  EXPECT_FALSE(
      cover_same_points(testing::index_range(0, 100), testing::index_range(10, 110), 0.95));
  EXPECT_TRUE(cover_same_points(testing::index_range(0, 100), testing::index_range(10, 110),
                                0.8));  // 90 of 110
  EXPECT_FALSE(cover_same_points(testing::index_range(0, 50), testing::index_range(50, 100), 0.0));
  EXPECT_FALSE(cover_same_points({}, {}, 0.5));
}

TEST(Merge, RefusesOptionsOutOfRange) {
  MergeOptions options;
  options.same_object = 1.5;
  try {
    options.validate();
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "same_object: expected a number in [0, 1] IoU, found 1.5");
  }
}

}  // namespace
}  // namespace symscene
