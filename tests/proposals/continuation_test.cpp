#include "proposals/surface_continuation.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace symscene {
namespace {

const ContinuationOptions options;

/// A horizontal patch of 9 × 5 points, 4 cm long and 2 cm wide, from x on. [m]
PointCloud patch(float x, float z = 0.0F) {
  PointCloud cloud;
  cloud.positions.resize(45, 3);
  cloud.normals = Points::Zero(45, 3);
  cloud.normals.col(2).setOnes();
  for (Index i = 0; i < 45; ++i) {
    cloud.positions.row(i) << x + 0.005F * static_cast<float>(i % 9),
        0.005F * static_cast<float>(i / 9), z;
  }
  return cloud;
}

SurfaceSample sample(const PointCloud& cloud, const PointIndices& points) {
  return sample_surface(cloud, points, static_cast<Index>(options.sample_points));
}

double continuation_of(const PointCloud& a, const PointCloud& b, const DistanceField& field) {
  return continuation(sample(a, testing::all_of(a)), sample(b, testing::all_of(b)), field, options);
}

double hidden_continuation(const PointCloud& a, const PointCloud& b) {
  return continuation_of(a, b, testing::nothing_known(testing::joined(a, b)));
}

PointCloud turned(const PointCloud& cloud, double angle) {
  const Eigen::Vector3d center = centroid(cloud.positions);
  const Eigen::Isometry3d motion = Eigen::Translation3d(center) *
                                   Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()) *
                                   Eigen::Translation3d(-center);
  return testing::moved(cloud, motion);
}

TEST(SurfaceSample, HasABallAroundItsPoints) {
  const PointCloud cloud = patch(0.1F);
  const SurfaceSample all = sample(cloud, testing::all_of(cloud));
  EXPECT_EQ(all.positions, cloud.positions);
  EXPECT_EQ(all.normals, cloud.normals);
  EXPECT_LT((all.center - Eigen::Vector3f(0.12F, 0.01F, 0.0F)).norm(), 1e-6F);
  EXPECT_NEAR(all.radius, std::hypot(0.02F, 0.01F), 1e-6F);
  const SurfaceSample corner = sample(cloud, {0});
  EXPECT_EQ(corner.positions.rows(), 1);
  EXPECT_EQ(corner.radius, 0.0F);
  const PointCloud vase = testing::vase();
  const SurfaceSample few = sample(vase, testing::all_of(vase));
  EXPECT_LE(few.positions.rows(), 90);
  EXPECT_EQ(few.normals.rows(), few.positions.rows());
}

TEST(Continuation, OfCoplanarPatchesWithAHiddenGapIsOne) {
  EXPECT_DOUBLE_EQ(hidden_continuation(patch(0.0F), patch(0.14F)), 1.0);
  EXPECT_DOUBLE_EQ(hidden_continuation(patch(0.14F), patch(0.0F)), 1.0);
}

TEST(Continuation, IsTheSmallerShareOfBoth) {
  // Half of the other surface is a step of 5 cm up.
  const PointCloud half = testing::joined(patch(0.14F), patch(0.14F, 0.05F));
  EXPECT_DOUBLE_EQ(hidden_continuation(patch(0.0F), half), 0.5);
  EXPECT_DOUBLE_EQ(hidden_continuation(half, patch(0.0F)), 0.5);
}

TEST(Continuation, IsZeroWhereTheGapWasSeenEmpty) {
  const PointCloud a = patch(0.0F), b = patch(0.14F);
  EXPECT_EQ(continuation_of(a, b, testing::all_seen(testing::joined(a, b))), 0.0);
  // In a gap of 1 cm no place is 1 cm from both. Points are in the middle of their voxels.
  PointCloud close = testing::joined(a, patch(0.05F));
  close.positions.array() += 0.0025F;
  const DistanceField seen = testing::all_seen(close);
  PointIndices first = testing::all_of(a), second = testing::all_of(a);
  for (Index& i : second) i += a.size();
  EXPECT_EQ(continuation(sample(close, first), sample(close, second), seen, options), 1.0);
}

TEST(Continuation, OfOffsetParallelPatchesIsZero) {
  EXPECT_EQ(hidden_continuation(patch(0.0F), patch(0.14F, 0.02F)), 0.0);
  EXPECT_EQ(hidden_continuation(patch(0.0F), patch(0.14F, 0.005F)), 1.0);
}

TEST(Continuation, OfPatchesThatFaceOtherWaysIsZero) {
  PointCloud away = patch(0.14F);
  away.normals *= -1.0F;
  EXPECT_EQ(hidden_continuation(patch(0.0F), away), 0.0);
  EXPECT_EQ(hidden_continuation(patch(0.0F), turned(patch(0.14F), radians(20.0))), 0.0);
  EXPECT_GT(hidden_continuation(patch(0.0F), turned(patch(0.14F), radians(3.0))), 0.9);
}

TEST(Continuation, IsZeroBeyondTheGreatestGap) {
  // The nearest points are 4 cm less apart than the patches begin.
  EXPECT_EQ(hidden_continuation(patch(0.0F), patch(0.23F)), 1.0);
  EXPECT_EQ(hidden_continuation(patch(0.0F), patch(0.245F)), 0.0);
  EXPECT_EQ(hidden_continuation(patch(0.0F), patch(1.0F)), 0.0);
}

}  // namespace
}  // namespace symscene
