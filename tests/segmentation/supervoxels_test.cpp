#include <gtest/gtest.h>

#include <set>

#include "segmentation/workspace.hpp"
#include "surfaces.hpp"
#include "symscene/core/error.hpp"
#include "symscene/segmentation/supervoxels.hpp"

namespace symscene {
namespace {

NeighborLists neighbors_of(const PointCloud& cloud) {
  return voxel_neighbors(cloud.positions, 0.005);
}

/// The points of each label.
std::vector<PointIndices> members(const Partition& partition) {
  std::vector<PointIndices> sets(partition.count);
  for (Index i = 0; i < partition.labels.size(); ++i) sets.at(partition.labels[i]).push_back(i);
  return sets;
}

/// The points that paths of neighbours within `points` reach from the first of them.
std::size_t connected_size(const NeighborLists& neighbors, const PointIndices& points) {
  std::set<Index> left(points.begin() + 1, points.end());
  PointIndices open{points.front()};
  for (std::size_t next = 0; next < open.size(); ++next) {
    for (const Index j : neighbors.of(open[next])) {
      if (left.erase(j) != 0) open.push_back(j);
    }
  }
  return open.size();
}

/// A box, and a second one `gap` beside it.
PointCloud two_boxes(float gap) {
  PointCloud other = testing::box({0.1, 0.1, 0.1});
  other.positions.col(0).array() += 0.1F + gap;
  return testing::joined(testing::box({0.1, 0.1, 0.1}), other);
}

TEST(Supervoxels, CoverEveryPointWithConnectedSets) {
  for (const PointCloud& cloud : {testing::vase(), testing::box({0.1, 0.16, 0.22})}) {
    const NeighborLists neighbors = neighbors_of(cloud);
    const Partition partition = supervoxels(cloud, neighbors);
    ASSERT_EQ(partition.labels.size(), cloud.size());
    for (const PointIndices& points : members(partition)) {
      ASSERT_FALSE(points.empty());
      EXPECT_EQ(connected_size(neighbors, points), points.size());
    }
  }
}

TEST(Supervoxels, DoNotCrossBetweenObjectsThatDoNotTouch) {
  const PointCloud cloud = two_boxes(0.02F);
  const Partition partition = facets(cloud, neighbors_of(cloud));
  for (const PointIndices& points : members(partition)) {
    const bool is_second = cloud.positions(points.front(), 0) > 0.06F;
    for (const Index i : points) EXPECT_EQ(cloud.positions(i, 0) > 0.06F, is_second);
  }
}

TEST(Supervoxels, KeepToTheEdgesOfABox) {
  const PointCloud cloud = testing::box({0.1, 0.16, 0.22});
  for (const PointIndices& points : members(supervoxels(cloud, neighbors_of(cloud)))) {
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (const Index i : points) mean += cloud.normal(i);
    mean.normalize();
    // The points on an edge have a normal half-way between the faces.
    for (const Index i : points) EXPECT_GT(mean.dot(cloud.normal(i)), 0.6F);
  }
}

TEST(Supervoxels, AreOfTheSizeThatTheirSeedsAreApart) {
  const PointCloud cloud = testing::box({0.2, 0.2, 0.2});
  for (const double spacing : {0.02, 0.04}) {
    SupervoxelOptions options;
    options.seed_spacing = spacing;
    const Partition partition = supervoxels(cloud, neighbors_of(cloud), options);
    // The faces have 6 · 0.2² m²; seeds at least this far apart have 0.5 to 2 spacing² each.
    const double area = 0.24 / static_cast<double>(partition.count);
    EXPECT_GT(area, 0.5 * spacing * spacing);
    EXPECT_LT(area, 2.0 * spacing * spacing);
  }
}

TEST(Facets, AreTheFacesOfABoxAndMoveWithIt) {
  const PointCloud box = testing::box({0.1, 0.16, 0.22});
  std::mt19937 generator(5);
  for (const PointCloud& cloud : {box, testing::moved(box, testing::random_motion(generator))}) {
    const Partition partition = facets(cloud, neighbors_of(cloud));
    std::size_t faces = 0;
    for (const PointIndices& points : members(partition)) faces += points.size() > 400 ? 1 : 0;
    EXPECT_EQ(faces, 6U);
    EXPECT_LE(partition.count, 8U);
  }
}

TEST(Supervoxels, AreNearlyTheSameAfterARigidMotion) {
  const PointCloud cloud = testing::vase();
  std::mt19937 generator(7);
  const PointCloud turned = testing::moved(cloud, testing::random_motion(generator));
  const Partition here = supervoxels(cloud, radius_neighbors(cloud.positions, 0.0087F));
  const Partition there = supervoxels(turned, radius_neighbors(turned.positions, 0.0087F));
  std::size_t together = 0, joined = 0;
  for (Index i = 1; i < cloud.size(); ++i) {
    const bool is_same = here.labels[i] == here.labels[i - 1];
    together += is_same ? 1 : 0;
    joined += is_same && there.labels[i] == there.labels[i - 1] ? 1 : 0;
  }
  EXPECT_GT(joined, together * 9 / 10);
}

TEST(Supervoxels, OfNothingAreNone) {
  const PointCloud nothing;
  const Partition partition = facets(nothing, radius_neighbors(nothing.positions, 0.01F));
  EXPECT_EQ(partition.count, 0U);
  EXPECT_TRUE(partition.labels.empty());
}

TEST(Supervoxels, OfPointsWithoutNeighboursAreThesePoints) {
  PointCloud cloud;
  cloud.positions.resize(3, 3);
  cloud.positions << 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F;
  cloud.normals = Eigen::RowVector3f::UnitZ().replicate(3, 1);
  EXPECT_EQ(facets(cloud, neighbors_of(cloud)).count, 3U);
}

TEST(Supervoxels, RefuseInvalidOptions) {
  SupervoxelOptions options;
  options.seed_spacing = 0.0;
  EXPECT_THROW(options.validate(), InputError);
  options = {};
  options.spatial_weight = options.normal_weight = 0.0;
  EXPECT_THROW(options.validate(), InputError);
}

}  // namespace
}  // namespace symscene
