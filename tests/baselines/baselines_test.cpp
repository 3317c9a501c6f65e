#include <gtest/gtest.h>

#include "baselines/graph_segmentation.hpp"
#include "surfaces.hpp"
#include "symscene/baselines/euclidean_sweep.hpp"
#include "symscene/baselines/felzenszwalb.hpp"
#include "symscene/baselines/lccp.hpp"
#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using testing::joined;

/// A flat patch of 2 n × n points, 5 mm apart, from the y axis along `direction`.
PointCloud patch(Index n, const Eigen::Vector3f& direction, const Eigen::Vector3f& normal) {
  PointCloud cloud;
  cloud.positions.resize(2 * n * n, 3);
  cloud.normals = normal.transpose().replicate(2 * n * n, 1);
  for (Index i = 0; i < 2 * n * n; ++i) {
    const auto along = static_cast<float>(i % n) + 0.5F, across = static_cast<float>(i / n);
    cloud.positions.row(i) =
        (0.005F * (along * direction + across * Eigen::Vector3f::UnitY())).transpose();
  }
  return cloud;
}

constexpr Index side = 20;
constexpr Index half = 2 * side * side;

/// Two patches that meet at a right angle: a floor and a wall, or the top and the side of a box.
PointCloud valley() {
  return joined(patch(side, {1, 0, 0}, {0, 0, 1}), patch(side, {0, 0, 1}, {1, 0, 0}));
}
PointCloud ridge() {
  return joined(patch(side, {-1, 0, 0}, {0, 0, 1}), patch(side, {0, 0, -1}, {1, 0, 0}));
}

/// A patch and the same again, `gap` beyond its end.
PointCloud two_patches(float gap) {
  const PointCloud one = patch(side, {1, 0, 0}, {0, 0, 1});
  PointCloud other = one;
  other.positions.col(0).array() += 0.005F * static_cast<float>(side - 1) + gap;
  return joined(one, other);
}

PointIndices range(Index begin, Index end) {
  PointIndices indices;
  for (Index i = begin; i < end; ++i) indices.push_back(i);
  return indices;
}

const std::vector<PointIndices> both_halves{range(0, half), range(half, 2 * half)};
const std::vector<PointIndices> one_whole{range(0, 2 * half)};

void expect_partition(const std::vector<PointIndices>& segments, Index size) {
  std::vector<bool> seen(size, false);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    EXPECT_TRUE(std::is_sorted(segments[s].begin(), segments[s].end()));
    if (s != 0) {
      EXPECT_GE(segments[s - 1].size(), segments[s].size());
    }
    for (const Index i : segments[s]) {
      EXPECT_FALSE(seen.at(i));
      seen[i] = true;
    }
  }
}

/// Two triangles with a bridge: 0-1-2 by 0.1, 0.1 and 0.2, 3-4-5 by 0.2, 0.2 and 0.3.
std::vector<DissimilarEdge> two_triangles(float bridge) {
  return {{3, 5, 0.3F}, {2, 3, bridge}, {0, 1, 0.1F}, {1, 2, 0.1F},
          {0, 2, 0.2F}, {3, 4, 0.2F},   {4, 5, 0.2F}};
}

TEST(GraphSegmentation, JoinsWhereTheBridgeIsNoWorseThanBothSides) {
  // Int + k / |C| with k = 0.6 is 0.1 + 0.2 on the left and 0.2 + 0.2 on the right.
  const std::vector<Index> apart{0, 0, 0, 3, 3, 3};
  const std::vector<Index> whole(6, 0);
  EXPECT_EQ(segment_graph(6, two_triangles(0.31F), 0.6, 0), apart);
  EXPECT_EQ(segment_graph(6, two_triangles(0.29F), 0.6, 0), whole);
  // k = 0.3 leaves 0.1 + 0.1 on the left.
  EXPECT_EQ(segment_graph(6, two_triangles(0.29F), 0.3, 0), apart);
}

TEST(GraphSegmentation, LeavesNodesAloneBelowAnyWeight) {
  EXPECT_EQ(segment_graph(6, two_triangles(0.5F), 0.09, 0), (std::vector<Index>{0, 1, 2, 3, 4, 5}));
}

TEST(GraphSegmentation, JoinsSmallComponentsByTheLeastEdge) {
  // Nothing joins by weight: 0.1 joins 0, 1 and 2, then 0.2 joins 3, 4 and 5.
  EXPECT_EQ(segment_graph(6, two_triangles(0.5F), 0.09, 2), (std::vector<Index>{0, 0, 0, 3, 3, 3}));
  EXPECT_EQ(segment_graph(6, two_triangles(0.5F), 0.09, 4), std::vector<Index>(6, 0));
}

TEST(GraphSegmentation, DoesNotDependOnTheOrderOfTheEdges) {
  std::vector<DissimilarEdge> edges = two_triangles(0.29F);
  std::reverse(edges.begin(), edges.end());
  EXPECT_EQ(segment_graph(6, edges, 0.3, 0), segment_graph(6, two_triangles(0.29F), 0.3, 0));
}

TEST(Felzenszwalb, CutsAValleyAndKeepsAPlane) {
  EXPECT_EQ(felzenszwalb_segments(valley()), both_halves);
  EXPECT_EQ(felzenszwalb_segments(two_patches(0.005F)), one_whole);
}

TEST(Felzenszwalb, ForgivesARidgeMoreThanAValleyOfTheSameAngle) {
  // At 45° a valley weighs 0.29 and a ridge 0.09; each side allows k / 800.
  const float s = std::sqrt(0.5F);
  const PointCloud floor = patch(side, {1, 0, 0}, {0, 0, 1});
  const PointCloud roof = patch(side, {-1, 0, 0}, {0, 0, 1});
  FelzenszwalbOptions options;
  options.k = 160.0;
  EXPECT_EQ(felzenszwalb_segments(joined(floor, patch(side, {-s, 0, s}, {s, 0, s})), options),
            both_halves);
  EXPECT_EQ(felzenszwalb_segments(joined(roof, patch(side, {s, 0, -s}, {s, 0, s})), options),
            one_whole);
}

TEST(Felzenszwalb, SweepEqualsTheSegmentsAtEachK) {
  const PointCloud cloud = joined(testing::box({0.1, 0.12, 0.08}), testing::vase());
  const BaselineSweep sweep = felzenszwalb_sweep(cloud);
  ASSERT_EQ(sweep.values.size(), 14U);
  EXPECT_DOUBLE_EQ(sweep.values.front(), 0.5);
  EXPECT_DOUBLE_EQ(sweep.values.back(), 7.0);
  for (std::size_t i = 0; i < sweep.values.size(); ++i) {
    FelzenszwalbOptions options;
    options.k = sweep.values[i];
    EXPECT_EQ(sweep.masks[i], felzenszwalb_segments(cloud, options));
    expect_partition(sweep.masks[i], cloud.size());
  }
}

TEST(Felzenszwalb, IsTheSameForAnyNumberOfThreads) {
  const PointCloud cloud = testing::vase();
  const auto run = [&] { return felzenszwalb_sweep(cloud).masks; };
  EXPECT_EQ(testing::with_threads(1, run), testing::with_threads(4, run));
}

TEST(EuclideanClusters, AreApartByMoreThanTheDistance) {
  EXPECT_EQ(euclidean_clusters(two_patches(0.011F)), both_halves);
  EXPECT_EQ(euclidean_clusters(two_patches(0.009F)), one_whole);
}

TEST(EuclideanClusters, LeaveOutSmallClusters) {
  const PointCloud cloud = joined(patch(3, {1, 0, 0}, {0, 0, 1}), two_patches(0.1F));
  EuclideanClusterOptions options;
  // The small patch lies on the first large one.
  EXPECT_EQ(euclidean_clusters(cloud, options).size(), 2U);
  options.min_size = static_cast<int>(half) + 1;
  EXPECT_EQ(euclidean_clusters(cloud, options).size(), 1U);
}

TEST(EuclideanClusters, OnlyGrowWithTheDistance) {
  const BaselineSweep sweep = euclidean_sweep(two_patches(0.0151F));
  ASSERT_EQ(sweep.values.size(), 11U);
  EXPECT_DOUBLE_EQ(sweep.values.front(), 0.005);
  EXPECT_DOUBLE_EQ(sweep.values.back(), 0.03);
  for (std::size_t i = 1; i < sweep.values.size(); ++i)
    EXPECT_EQ(sweep.masks[i], sweep.values[i] < 0.0151 ? both_halves : one_whole);
}

TEST(Lccp, CutsAValleyAndKeepsARidge) {
  if (!has_lccp()) GTEST_SKIP() << "no PCL";
  LccpOptions options;
  options.concavity_tolerance = radians(30.0);
  EXPECT_EQ(lccp_segments(valley(), options).size(), 2U);
  EXPECT_EQ(lccp_segments(ridge(), options).size(), 1U);
}

/// A low box and a high one beside it, as seen on a table: without bottoms and what touches.
struct TwoBoxes {
  PointCloud cloud;
  PointIndices low, high;
};

TwoBoxes two_boxes() {
  PointCloud high = testing::box({0.1, 0.1, 0.2});
  high.positions.col(0).array() += 0.15F;
  const PointCloud low = testing::box({0.2, 0.2, 0.1});
  const PointCloud both = joined(low, high);
  TwoBoxes boxes;
  PointIndices seen;
  for (Index i = 0; i < both.size(); ++i) {
    const Eigen::Vector3f at = both.position(i);
    const bool touches =
        std::abs(at.x() - 0.1F) < 0.003F && std::abs(at.y()) < 0.048F && at.z() < 0.098F;
    if (touches || at.z() < 0.003F) continue;
    (i < low.size() ? boxes.low : boxes.high).push_back(static_cast<Index>(seen.size()));
    seen.push_back(i);
  }
  boxes.cloud = select(both, seen);
  return boxes;
}

TEST(Lccp, SeparatesTwoBoxesThatTouch) {
  if (!has_lccp()) GTEST_SKIP() << "no PCL";
  const TwoBoxes boxes = two_boxes();
  LccpOptions options;
  options.concavity_tolerance = radians(30.0);
  const std::vector<PointIndices> segments = lccp_segments(boxes.cloud, options);
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_GT(intersection_over_union(segments[0], boxes.low), 0.9);
  EXPECT_GT(intersection_over_union(segments[1], boxes.high), 0.9);
}

TEST(Lccp, SweepEqualsTheSegmentsAtEachTolerance) {
  if (!has_lccp()) GTEST_SKIP() << "no PCL";
  const PointCloud cloud = joined(testing::box({0.1, 0.12, 0.08}), testing::vase());
  const BaselineSweep sweep = lccp_sweep(cloud);
  ASSERT_EQ(sweep.values.size(), 13U);
  EXPECT_DOUBLE_EQ(sweep.values.front(), radians(10.0));
  EXPECT_DOUBLE_EQ(sweep.values.back(), radians(70.0));
  for (std::size_t i = 0; i < sweep.values.size(); ++i) {
    LccpOptions options;
    options.concavity_tolerance = sweep.values[i];
    EXPECT_EQ(sweep.masks[i], lccp_segments(cloud, options));
    expect_partition(sweep.masks[i], cloud.size());
  }
}

TEST(Lccp, IsRefusedWithoutPcl) {
  if (has_lccp()) GTEST_SKIP() << "it is here";
  EXPECT_THROW(lccp_segments(valley()), InputError);
}

TEST(Baselines, FindTheSameInARotatedScene) {
  std::mt19937 generator(7);
  const PointCloud cloud = valley();
  const PointCloud turned = testing::moved(cloud, testing::random_motion(generator));
  EXPECT_EQ(felzenszwalb_segments(turned), both_halves);
  EXPECT_EQ(euclidean_clusters(turned), one_whole);
}

TEST(Baselines, FindNothingInAnEmptyCloud) {
  const BaselineSweep graph = felzenszwalb_sweep({});
  EXPECT_EQ(graph.masks, std::vector<std::vector<PointIndices>>(14));
  EXPECT_EQ(euclidean_sweep({}).masks, std::vector<std::vector<PointIndices>>(11));
  if (has_lccp()) {
    EXPECT_EQ(lccp_sweep({}).masks, std::vector<std::vector<PointIndices>>(13));
  }
}

TEST(Baselines, RefuseCloudsWithoutFiniteNormals) {
  PointCloud bare = valley();
  bare.normals.resize(0, 3);
  EXPECT_THROW(felzenszwalb_segments(bare), InputError);
  EXPECT_EQ(euclidean_clusters(bare), one_whole);
  PointCloud broken = valley();
  broken.normals(3, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(felzenszwalb_segments(broken), InputError);
  EXPECT_THROW(lccp_segments(broken), InputError);
  broken.positions(3, 1) = std::numeric_limits<float>::infinity();
  EXPECT_THROW(euclidean_clusters(broken), InputError);
}

TEST(Baselines, RefuseOptionsOutOfTheirRange) {
  const PointCloud cloud = valley();
  EXPECT_THROW(felzenszwalb_sweep(cloud, {}, {1.0, 0.0}), InputError);
  EXPECT_THROW(euclidean_sweep(cloud, {}, {-0.01}), InputError);
  EXPECT_THROW(lccp_sweep(cloud, {}, {radians(200.0)}), InputError);
  FelzenszwalbOptions graph;
  graph.neighbors = 0;
  EXPECT_THROW(felzenszwalb_segments(cloud, graph), InputError);
  EuclideanClusterOptions clusters;
  clusters.min_size = 0;
  EXPECT_THROW(euclidean_clusters(cloud, clusters), InputError);
  LccpOptions patches;
  patches.seed_spacing = 0.001;
  EXPECT_THROW(lccp_segments(cloud, patches), InputError);
}

}  // namespace
}  // namespace symscene
