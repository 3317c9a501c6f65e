#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "core/random_clouds.hpp"
#include "symmetry/boundary_points.hpp"
#include "symmetry/ordered_paths.hpp"
#include "symmetry/path_joining.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/geometry.hpp"
#include "symscene/symmetry/edge_curves.hpp"

namespace symscene {
namespace {

Points points_of(const std::vector<Eigen::Vector3f>& positions) {
  Points points(static_cast<Eigen::Index>(positions.size()), 3);
  for (std::size_t k = 0; k < positions.size(); ++k)
    points.row(static_cast<Eigen::Index>(k)) = positions[k].transpose();
  return points;
}

/// `count` points 5 mm apart from `start` along `direction`.
std::vector<Eigen::Vector3f> line(const Eigen::Vector3f& start, const Eigen::Vector3f& direction,
                                  int count) {
  std::vector<Eigen::Vector3f> points;
  for (int k = 0; k < count; ++k)
    points.push_back(start + 0.005F * static_cast<float>(k) * direction);
  return points;
}

/// A flat square patch of points 5 mm apart in the plane z = 0, its first corner at the origin.
PointCloud patch(int side) {
  PointCloud cloud;
  cloud.positions.resize(side * side, 3);
  cloud.normals = Eigen::RowVector3f::UnitZ().replicate(side * side, 1);
  for (int i = 0; i < side * side; ++i) {
    cloud.positions.row(i) << 0.005F * static_cast<float>(i % side),
        0.005F * static_cast<float>(i / side), 0.0F;
  }
  return cloud;
}

NeighborLists adjacent(const PointCloud& cloud) {
  return radius_neighbors(cloud.positions, 0.0087F);
}

TEST(OrderedPaths, HoldEveryPointOnce) {
  const Points points = testing::random_points(3, 400, 0.05);
  std::set<Index> seen;
  for (const PointIndices& path : ordered_paths(points, 0.012)) {
    for (const Index i : path) EXPECT_TRUE(seen.insert(i).second);
    for (std::size_t k = 1; k < path.size(); ++k)
      EXPECT_LE((points.row(path[k]) - points.row(path[k - 1])).norm(), 0.01201F);
  }
  EXPECT_EQ(seen.size(), 400U);
}

TEST(OrderedPaths, OfAForkAreItsLongestPathAndTheBranch) {
  // A long line, and a branch of six points from its middle.
  std::vector<Eigen::Vector3f> fork = line({0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, 21);
  for (const Eigen::Vector3f& p : line({0.05F, 0.005F, 0.0F}, {0.0F, 1.0F, 0.0F}, 6))
    fork.push_back(p);
  const std::vector<PointIndices> paths = ordered_paths(points_of(fork), 0.006);
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_EQ(paths[0].size(), 21U);
  EXPECT_EQ(paths[1].size(), 6U);
  EXPECT_TRUE(std::is_sorted(paths[0].begin(), paths[0].end()) ||
              std::is_sorted(paths[0].rbegin(), paths[0].rend()));
}

TEST(OrderedPaths, OfAClosedLineOpenItAtItsLongestLink) {
  std::vector<Eigen::Vector3f> circle;
  for (int k = 0; k < 40; ++k) {
    const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(k) / 40.5F;
    circle.emplace_back(0.04F * std::cos(angle), 0.04F * std::sin(angle), 0.0F);
  }
  const std::vector<PointIndices> paths = ordered_paths(points_of(circle), 0.012);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(std::set<Index>({paths[0].front(), paths[0].back()}), std::set<Index>({0, 39}));
}

TEST(OrderedPaths, OfNothingAreNone) { EXPECT_TRUE(ordered_paths(Points(0, 3), 0.01).empty()); }

/// The paths of lines of five nodes each, joined.
std::vector<PointIndices> joined_lines(const std::vector<std::vector<Eigen::Vector3f>>& lines) {
  BoundaryNodes nodes;
  std::vector<PointIndices> paths;
  for (const std::vector<Eigen::Vector3f>& points : lines) {
    PointIndices& path = paths.emplace_back();
    for (const Eigen::Vector3f& p : points) {
      path.push_back(static_cast<Index>(nodes.size()));
      nodes.push_back({p.cast<double>(), Eigen::Vector3d::Zero(), {}});
    }
  }
  return joined_paths(nodes, paths, {});
}

TEST(JoinedPaths, GoOnWhereALineIsBrokenInAnyDirection) {
  const Eigen::Vector3f x(1.0F, 0.0F, 0.0F);
  const auto first = line({0.0F, 0.0F, 0.0F}, x, 5), second = line({0.03F, 0.0F, 0.0F}, x, 5);
  const auto backwards = line({0.08F, 0.0F, 0.0F}, -x, 5);
  const std::vector<PointIndices> joined = joined_lines({second, first, backwards});
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_EQ(joined[0].size(), 15U);
}

TEST(JoinedPaths, StopAtACornerAndAtAWideGap) {
  const Eigen::Vector3f x(1.0F, 0.0F, 0.0F), y(0.0F, 1.0F, 0.0F);
  const auto first = line({0.0F, 0.0F, 0.0F}, x, 5);
  EXPECT_EQ(joined_lines({first, line({0.025F, 0.005F, 0.0F}, y, 5)}).size(), 2U);
  EXPECT_EQ(joined_lines({first, line({0.05F, 0.0F, 0.0F}, x, 5)}).size(), 2U);
  // Side by side.
  EXPECT_EQ(joined_lines({first, line({0.0F, 0.01F, 0.0F}, x, 5)}).size(), 2U);
}

TEST(EdgeCurves, OfAPatchAreTheFourSidesOfItsOutline) {
  const PointCloud cloud = patch(24);
  const std::vector<Index> facets(cloud.size(), 0);
  const std::vector<EdgeCurve> curves = edge_curves(cloud, adjacent(cloud), facets);
  ASSERT_EQ(curves.size(), 4U);
  for (const EdgeCurve& curve : curves) {
    EXPECT_GT(curve.length(), 0.08);
    const Eigen::Vector3d direction =
        (curve.points.back().position - curve.points.front().position).normalized();
    EXPECT_GT(direction.cwiseAbs().maxCoeff(), 0.999);
    for (const EdgeCurve::Point& point : curve.points) {
      EXPECT_LT(line_angle(point.tangent, direction), radians(12.0));
      EXPECT_FALSE(point.members.empty());
    }
  }
  EdgeCurveOptions inside;
  inside.outlines = false;
  EXPECT_TRUE(edge_curves(cloud, adjacent(cloud), facets, inside).empty());
}

TEST(EdgeCurves, LeaveOutTheBordersOfFacetsWhereTheSurfaceIsFlat) {
  const PointCloud cloud = patch(24);
  std::vector<Index> facets(cloud.size(), 0);
  for (Index i = 0; i < cloud.size(); ++i) facets[i] = cloud.positions(i, 0) < 0.06F ? 0 : 1;
  EdgeCurveOptions options;
  options.outlines = false;
  EXPECT_TRUE(edge_curves(cloud, adjacent(cloud), facets, options).empty());
  options.min_bend = 0.0;
  const std::vector<EdgeCurve> curves = edge_curves(cloud, adjacent(cloud), facets, options);
  ASSERT_EQ(curves.size(), 1U);
  for (const EdgeCurve::Point& point : curves[0].points)
    EXPECT_NEAR(point.position.x(), 0.0575, 0.0005);
}

TEST(EdgeCurves, StandForEveryBoundaryPointAtMostOnce) {
  const PointCloud cloud = patch(24);
  const std::vector<Index> facets(cloud.size(), 0);
  const PointIndices boundary = boundary_points(cloud, adjacent(cloud), facets, {});
  EXPECT_EQ(boundary.size(), 4U * 23U);
  std::set<Index> seen;
  for (const EdgeCurve& curve : edge_curves(cloud, adjacent(cloud), facets)) {
    for (const EdgeCurve::Point& point : curve.points) {
      for (const Index i : point.members) {
        EXPECT_TRUE(seen.insert(i).second);
        EXPECT_TRUE(std::binary_search(boundary.begin(), boundary.end(), i));
      }
    }
  }
}

TEST(EdgeCurves, RefuseInvalidOptions) {
  EdgeCurveOptions options;
  options.link_distance = options.spacing;
  EXPECT_THROW(options.validate(), InputError);
  EXPECT_THROW(edge_curves({}, {}, {}, options), InputError);
}

}  // namespace
}  // namespace symscene
