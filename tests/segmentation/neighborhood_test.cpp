#include "segmentation/neighborhood.hpp"

#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "index_range.hpp"
#include "surfaces.hpp"
#include "symscene/segmentation/reflectional_segmentation.hpp"
#include "symscene/segmentation/rotational_segmentation.hpp"
#include "symscene/segmentation/surface_graph.hpp"

namespace symscene {
namespace {

using testing::all_seen;
using testing::index_range;
using testing::joined;
using testing::vase;

/// `count` vases in a row, each a metre from the next; all have the same indices but for an offset.
PointCloud vases(int count) {
  PointCloud cloud = vase();
  for (int k = 1; k < count; ++k) {
    const Eigen::Isometry3d away(Eigen::Translation3d(static_cast<double>(k), 0.0, 0.0));
    cloud = joined(cloud, testing::moved(vase(), away));
  }
  return cloud;
}

TEST(Neighborhoods, HoldThePointsWithinReachAndTheEdgesBetweenThem) {
  const PointCloud cloud = vases(2);
  const std::vector<WeightedEdge> edges = surface_graph(cloud);
  const DistanceField field = all_seen(cloud);
  const NeighborhoodOptions options{.reach = 1.5, .margin = 0.05};
  const Neighborhoods neighborhoods({cloud, edges, field}, options);
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const auto first = std::uniform_int_distribution<Index>(0, cloud.size() - 40)(random);
    PointIndices support;
    for (Index i = first; i < first + 40; ++i) support.push_back(i);
    const auto part = neighborhoods.around(support);
    ASSERT_TRUE(part);

    const Eigen::Vector3f center = centroid(cloud.positions, support).cast<float>();
    float radius = 0.0F;
    for (const Index i : support) radius = std::max(radius, (cloud.position(i) - center).norm());
    const float reach = 1.5F * radius + 0.05F;
    std::vector<bool> inside(cloud.size(), false);
    for (const Index i : part->original) inside[i] = true;
    for (Index i = 0; i < cloud.size(); ++i) {
      const float distance = (cloud.position(i) - center).norm();
      if (std::abs(distance - reach) > 1e-3F) {
        EXPECT_EQ(inside[i], distance < reach) << i;
      }
    }
    std::size_t between = 0;
    for (const WeightedEdge& edge : edges) between += inside[edge.a] && inside[edge.b] ? 1 : 0;
    EXPECT_EQ(part->edges.size(), between);
    EXPECT_EQ(part->in_whole(part->in_part(support)), support);
    for (const WeightedEdge& edge : part->edges)
      EXPECT_LT((part->cloud.position(edge.a) - part->cloud.position(edge.b)).norm(), 0.03F);
  }
}

TEST(Neighborhoods, OfAllPointsAreNoPart) {
  const PointCloud cloud = vase();
  const std::vector<WeightedEdge> edges = surface_graph(cloud);
  const DistanceField field = all_seen(cloud);
  const Neighborhoods neighborhoods({cloud, edges, field}, {});
  EXPECT_FALSE(neighborhoods.around(index_range(0, cloud.size())));
  EXPECT_FALSE(neighborhoods.around({}));
}

/// The points of the vase at the origin that an axis and a plane cut out of a row of vases.
std::tuple<PointIndices, PointIndices> cut_from_row(int count) {
  const PointCloud cloud = vases(count);
  const std::vector<WeightedEdge> edges = surface_graph(cloud);
  const DistanceField field = all_seen(cloud);
  const PointIndices support = index_range(0, vase().size() / 2);
  const RotationAxis axis{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()};
  const ReflectionPlane plane{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY()};
  const auto rotational = segment_rotational({cloud, edges, field}, {{axis, {}, support}}, {});
  const auto reflectional = segment_reflectional({cloud, edges, field}, {{plane, {}, support}}, {});
  EXPECT_EQ(reflectional.hypotheses.size(), 1U);
  if (reflectional.hypotheses.empty()) return {rotational[0].points, {}};
  return {rotational[0].points, reflectional.hypotheses[0].points};
}

TEST(Neighborhoods, CutsDoNotDependOnObjectsOutOfReach) {
  const auto [alone_by_axis, alone_by_plane] = cut_from_row(1);
  ASSERT_GT(alone_by_axis.size(), vase().size() * 9 / 10);
  ASSERT_GT(alone_by_plane.size(), vase().size() * 9 / 10);
  // The plane y = 0 mirrors every vase of the row.
  const auto [by_axis, by_plane] = cut_from_row(4);
  EXPECT_EQ(by_axis, alone_by_axis);
  EXPECT_EQ(by_plane, alone_by_plane);
}

}  // namespace
}  // namespace symscene
