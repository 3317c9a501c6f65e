#include "symscene/core/point_cloud.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/random_clouds.hpp"

namespace symscene {
namespace {

using testing::random_points;
using testing::seeds;

PointIndices random_subset(std::uint32_t seed, Index universe) {
  std::mt19937 generator(seed);
  PointIndices subset;
  for (Index i = 0; i < universe; ++i) {
    if (generator() % 3 == 0) subset.push_back(i);
  }
  return subset;
}

TEST(Select, ReturnsPositionsNormalsAndColoursInTheOrderOfTheIndices) {
  PointCloud cloud;
  cloud.positions = random_points(1, 10);
  cloud.normals = random_points(2, 10);
  cloud.colors = Colors::Constant(10, 3, 7);
  cloud.colors(4, 1) = 200;
  const PointIndices indices{9, 4, 4};
  const PointCloud selected = select(cloud, indices);
  ASSERT_EQ(selected.size(), 3U);
  for (Index k = 0; k < 3; ++k) {
    EXPECT_EQ(selected.position(k), cloud.position(indices[k]));
    EXPECT_EQ(selected.normal(k), cloud.normal(indices[k]));
    EXPECT_EQ(selected.colors.row(k), cloud.colors.row(indices[k]));
  }
}

TEST(Select, AddsNoNormalsOrColours) {
  PointCloud cloud;
  cloud.positions = random_points(1, 10);
  const PointCloud selected = select(cloud, PointIndices{1, 2});
  EXPECT_FALSE(selected.has_normals());
  EXPECT_FALSE(selected.has_colors());
  EXPECT_TRUE(select(cloud, PointIndices{}).empty());
}

TEST(IntersectionOverUnion, EqualsThatOfSets) {
  for (const std::uint32_t seed : seeds) {
    const PointIndices a = random_subset(seed, 200);
    const PointIndices b = random_subset(seed + 100, 200);
    std::set<Index> united(a.begin(), a.end());
    united.insert(b.begin(), b.end());
    const std::size_t common = a.size() + b.size() - united.size();
    EXPECT_EQ(intersection_size(a, b), common);
    EXPECT_EQ(intersection_over_union(a, b),
              static_cast<double>(common) / static_cast<double>(united.size()));
    EXPECT_EQ(intersection_over_union(a, b), intersection_over_union(b, a));
    EXPECT_EQ(intersection_over_union(a, a), 1.0);
  }
}

TEST(IntersectionOverUnion, OfEmptySetsIsZero) {
  EXPECT_EQ(intersection_over_union({}, {}), 0.0);
  EXPECT_EQ(intersection_over_union(PointIndices{1}, {}), 0.0);
}

TEST(BoundingBox, IsTight) {
  const Points points = random_points(3, 100);
  const Box box = bounding_box(points);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(box.min[axis], points.col(axis).minCoeff());
    EXPECT_EQ(box.max[axis], points.col(axis).maxCoeff());
  }
  EXPECT_EQ(box.padded(0.5F).extent(),
            ((box.max.array() + 0.5F) - (box.min.array() - 0.5F)).matrix());
}

TEST(BoundingBox, OfNoPointsIsEmpty) {
  const Box box = bounding_box(Points(0, 3));
  EXPECT_GT(box.min.x(), box.max.x());
}

TEST(Centroid, OfAllPointsEqualsThatOfAllIndices) {
  const Points points = random_points(4, 99);
  PointIndices all(99);
  for (Index i = 0; i < 99; ++i) all[i] = i;
  EXPECT_LT((centroid(points) - centroid(points, all)).norm(), 1e-12);
  EXPECT_EQ(centroid(Points(0, 3)), Eigen::Vector3d::Zero());
  EXPECT_EQ(centroid(points, PointIndices{}), Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace symscene
