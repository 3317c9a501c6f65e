#include <gtest/gtest.h>

#include "segmentation/graph_cut.hpp"
#include "segmentation/labeling.hpp"
#include "segmentation/region_growing.hpp"
#include "surfaces.hpp"
#include "symscene/core/error.hpp"
#include "symscene/segmentation/hypothesis.hpp"
#include "symscene/segmentation/oversegmentation.hpp"
#include "symscene/segmentation/surface_graph.hpp"

namespace symscene {
namespace {

using testing::joined;

std::vector<PointIndices> segments_of(const PointCloud& cloud,
                                      const OversegmentationOptions& options = {}) {
  return oversegment(cloud, radius_neighbors(cloud.positions, 0.00866F), options);
}

TEST(Oversegmentation, FindsTheFacesOfABox) {
  const PointCloud cloud = testing::box({0.12, 0.15, 0.18});
  const std::vector<PointIndices> segments = segments_of(cloud);
  std::size_t faces = 0;
  for (const PointIndices& segment : segments) {
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (const Index i : segment) mean += cloud.normal(i);
    faces += mean.norm() / static_cast<float>(segment.size()) > 0.98F ? 1 : 0;
  }
  EXPECT_EQ(faces, 6U);
}

TEST(Oversegmentation, KeepsASmoothSurfaceInOnePiece) {
  const std::array<ProfilePoint, 4> profile{
      ProfilePoint{0.0, 0.0}, {0.06, 0.0}, {0.06, 0.2}, {0.0, 0.2}};
  const PointCloud can = testing::as_cloud(make_revolution(profile, 96, 0.005));
  const std::vector<PointIndices> segments = segments_of(can);
  ASSERT_FALSE(segments.empty());
  std::size_t side = 0;
  for (Index i = 0; i < can.size(); ++i) side += std::abs(can.normals(i, 2)) < 0.1F ? 1 : 0;
  EXPECT_GT(segments[0].size(), side * 9 / 10);
}

TEST(Oversegmentation, OfOneAngleIsAPartitionIntoAscendingSets) {
  const PointCloud cloud = testing::vase();
  OversegmentationOptions options;
  options.min_size = 3;
  const auto regions =
      grow_regions(cloud, radius_neighbors(cloud.positions, 0.00866F), radians(10.0), options);
  ASSERT_FALSE(regions.empty());
  std::vector<bool> seen(cloud.size(), false);
  for (const PointIndices& region : regions) {
    EXPECT_TRUE(std::is_sorted(region.begin(), region.end()));
    for (const Index i : region) {
      EXPECT_FALSE(seen[i]);
      seen[i] = true;
    }
  }
}

TEST(Oversegmentation, KeepsOneOfTwoSegmentsThatBothAnglesGive) {
  const std::vector<PointIndices> segments = segments_of(testing::vase());
  ASSERT_GT(segments.size(), 1U);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_LE(intersection_over_union(segments[i], segments[j]), 0.8);
      EXPECT_LE(segments[i].size(), segments[j].size());
    }
  }
}

TEST(SurfaceGraph, HasEachEdgeOnceAndNoneTooLong) {
  const PointCloud cloud = testing::vase();
  const std::vector<WeightedEdge> edges = surface_graph(cloud);
  ASSERT_FALSE(edges.empty());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    EXPECT_LT(edges[e].a, edges[e].b);
    if (e != 0) {
      EXPECT_LT(std::pair(edges[e - 1].a, edges[e - 1].b), std::pair(edges[e].a, edges[e].b));
    }
    EXPECT_LE((cloud.position(edges[e].a) - cloud.position(edges[e].b)).norm(), 0.01F);
    EXPECT_GT(edges[e].weight, 0.0F);
    EXPECT_LE(edges[e].weight, 1.0F);
  }
}

TEST(SurfaceGraph, IsWeakWhereTheSurfaceBendsInwardsOnly) {
  // A ridge and a valley of the same right angle.
  PointCloud bend;
  bend.positions.resize(2, 3);
  bend.normals.resize(2, 3);
  bend.positions << -0.002F, 0.0F, -0.002F, 0.002F, 0.0F, -0.002F;
  const float diagonal = std::sqrt(0.5F);
  bend.normals << -diagonal, 0.0F, diagonal, diagonal, 0.0F, diagonal;
  EXPECT_GT(surface_graph(bend).at(0).weight, 0.5F);
  bend.normals.col(0) *= -1.0F;
  EXPECT_LT(surface_graph(bend).at(0).weight, 0.01F);
}

TEST(SurfaceGraph, MovesWithTheScene) {
  std::mt19937 generator(4);
  const PointCloud cloud = testing::vase();
  const PointCloud turned = testing::moved(cloud, testing::random_motion(generator));
  const std::vector<WeightedEdge> here = surface_graph(cloud);
  const std::vector<WeightedEdge> there = surface_graph(turned);
  std::size_t common = 0;
  std::size_t equal = 0;
  for (const WeightedEdge& edge : here) {
    const auto other = std::lower_bound(there.begin(), there.end(), edge,
                                        [](const WeightedEdge& x, const WeightedEdge& y) {
                                          return std::pair(x.a, x.b) < std::pair(y.a, y.b);
                                        });
    if (other == there.end() || other->a != edge.a || other->b != edge.b) continue;
    ++common;
    equal += std::abs(edge.weight - other->weight) < 1e-4F ? 1 : 0;
  }
  // Rounding moves a point over the radius, or a flat edge from convex to concave, now and then.
  const auto count = static_cast<double>(here.size());
  EXPECT_NEAR(static_cast<double>(there.size()), count, 0.01 * count);
  EXPECT_GT(static_cast<double>(common), 0.99 * count);
  EXPECT_GT(static_cast<double>(equal), 0.99 * static_cast<double>(common));
}

TEST(Components, CountFromTheLowestNodeAndSkipBackground) {
  const std::vector<std::uint8_t> is_object{1, 0, 1, 1, 1, 0};
  const std::vector<WeightedEdge> edges{{0, 3, 1.0F}, {0, 1, 1.0F}, {1, 2, 1.0F}, {2, 4, 1.0F}};
  EXPECT_EQ(connected_components(is_object, edges),
            (std::vector<Index>{0, no_component, 1, 0, 1, no_component}));
}

TEST(Components, OfALongChainAreOne) {
  constexpr Index count = 20000;
  std::vector<WeightedEdge> edges;
  for (Index i = count - 1; i > 0; --i) edges.push_back({i, i - 1, 1.0F});
  const std::vector<Index> component =
      connected_components(std::vector<std::uint8_t>(count, 1), edges);
  EXPECT_TRUE(std::all_of(component.begin(), component.end(), [](Index c) { return c == 0; }));
}

TEST(Smoothness, IsTheEnergyOfTheCutPerPointWithoutAffinities) {
  std::mt19937 generator(3);
  for (int run = 0; run < 20; ++run) {
    std::vector<WeightedEdge> edges(300);
    for (WeightedEdge& edge : edges) {
      edge.a = static_cast<Index>(generator() % 50);
      edge.b = (edge.a + 1 + static_cast<Index>(generator() % 49)) % 50;
      edge.weight = static_cast<float>(generator() % 1024) / 1024.0F;
    }
    std::vector<std::uint8_t> is_object(50);
    for (std::uint8_t& label : is_object) label = static_cast<std::uint8_t>(generator() % 2);
    const auto size = static_cast<double>(object_nodes(is_object).size());
    EXPECT_DOUBLE_EQ(size * smoothness(is_object, edges),
                     labeling_energy(std::vector<Affinity>(50), edges, is_object));
  }
  EXPECT_EQ(smoothness({0, 0}, std::vector<WeightedEdge>{{0, 1, 1.0F}}), 0.0) << "no object";
}

TEST(Confidence, FallsFromOneToZeroAtTheBounds) {
  const HypothesisBounds bounds{0.3, 0.1, 0.2, 1};
  EXPECT_DOUBLE_EQ(confidence({0.0, 0.0, 0.0}, bounds), 1.0);
  EXPECT_DOUBLE_EQ(confidence({0.3, 0.0, 0.0}, bounds), 0.0);
  EXPECT_GT(confidence({0.1, 0.01, 0.1}, bounds), confidence({0.1, 0.02, 0.1}, bounds));
}

TEST(SegmentationOptions, OutOfRangeAreRefused) {
  OversegmentationOptions oversegmentation;
  oversegmentation.fine_angle = 0.0;
  EXPECT_THROW(segments_of(testing::vase(), oversegmentation), InputError);
  SurfaceGraphOptions graph;
  graph.concave_sigma = 0.0;
  EXPECT_THROW(surface_graph(testing::vase(), graph), InputError);
}

TEST(SurfaceGraph, OfTwoBoxesSideBySideIsWeakBetweenThem) {
  PointCloud left = testing::box({0.1, 0.1, 0.1});
  PointCloud right = testing::box({0.1, 0.1, 0.06});
  right.positions.col(0).array() += 0.1F;
  const Index boundary = left.size();
  const PointCloud both = joined(left, right);
  double between = 0.0;
  double count = 0.0;
  for (const WeightedEdge& edge : surface_graph(both)) {
    const bool crosses = (edge.a < boundary) != (edge.b < boundary);
    const bool on_outside =
        both.positions(edge.a, 2) > 0.06F && both.positions(edge.b, 2) <= 0.061F;
    if (crosses && on_outside) {
      between += double{edge.weight};
      count += 1.0;
    }
  }
  ASSERT_GT(count, 0.0);
  EXPECT_LT(between / count, 0.1);
}

}  // namespace
}  // namespace symscene
