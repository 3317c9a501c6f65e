#include "symscene/core/neighbors.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random_clouds.hpp"
#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using testing::clouds_of_all_kinds;
using testing::random_points;

/// Brute force with the same arithmetic as the search, so that equal sets of points are expected.
float squared_distance(const Points& points, Index i, const Eigen::Vector3f& query) {
  const float dx = points(i, 0) - query.x();
  const float dy = points(i, 1) - query.y();
  const float dz = points(i, 2) - query.z();
  return dx * dx + dy * dy + dz * dz;
}

std::vector<Index> within(const Points& points, Index query, float radius) {
  std::vector<Index> found;
  for (Index j = 0; j < points.rows(); ++j) {
    if (j != query && squared_distance(points, j, points.row(query).transpose()) <= radius * radius)
      found.push_back(j);
  }
  return found;
}

std::vector<float> sorted_distances(const Points& points, Index query) {
  std::vector<float> distances;
  for (Index j = 0; j < points.rows(); ++j) {
    if (j != query) distances.push_back(squared_distance(points, j, points.row(query).transpose()));
  }
  std::sort(distances.begin(), distances.end());
  return distances;
}

std::vector<Index> list(std::span<const Index> indices) { return {indices.begin(), indices.end()}; }

TEST(RadiusNeighbors, EqualBruteForce) {
  for (const auto& [kind, points] : clouds_of_all_kinds()) {
    for (const float radius : {0.005F, 0.01F, 0.0300001F, 0.5F}) {
      const NeighborLists lists = radius_neighbors(points, radius);
      ASSERT_EQ(lists.size(), static_cast<std::size_t>(points.rows())) << kind;
      for (Index i = 0; i < points.rows(); ++i) {
        ASSERT_EQ(list(lists.of(i)), within(points, i, radius)) << kind << ", " << i;
      }
    }
  }
}

TEST(RadiusNeighbors, IncludePointsExactlyARadiusAwayWhereverTheLatticeLies) {
  for (int shift = 0; shift < 400; ++shift) {
    Points points = Points::Zero(40, 3);
    for (Index i = 0; i < points.rows(); ++i)
      points(i, 0) = 0.005F * static_cast<float>(i) + 0.0123F * static_cast<float>(shift);
    const NeighborLists lists = radius_neighbors(points, 0.005F);
    for (Index i = 0; i < points.rows(); ++i)
      ASSERT_EQ(list(lists.of(i)), within(points, i, 0.005F)) << shift << ", " << i;
  }
}

TEST(RadiusNeighbors, AreMutual) {
  const Points points = random_points(3, 500);
  const NeighborLists lists = radius_neighbors(points, 0.03F);
  for (Index i = 0; i < points.rows(); ++i) {
    for (const Index j : lists.of(i)) {
      EXPECT_TRUE(std::binary_search(lists.of(j).begin(), lists.of(j).end(), i));
    }
  }
}

TEST(NearestNeighbors, HaveTheDistancesOfBruteForce) {
  for (const auto& [kind, points] : clouds_of_all_kinds()) {
    for (const std::size_t count : {1U, 4U, 10U, 100U}) {
      const NeighborLists lists = nearest_neighbors(points, count);
      ASSERT_EQ(lists.size(), static_cast<std::size_t>(points.rows())) << kind;
      for (Index i = 0; i < points.rows(); ++i) {
        std::vector<float> expected = sorted_distances(points, i);
        expected.resize(std::min(count, expected.size()));
        std::vector<float> found;
        for (const Index j : lists.of(i)) {
          ASSERT_NE(j, i) << kind;
          found.push_back(squared_distance(points, j, points.row(i).transpose()));
        }
        ASSERT_EQ(found, expected) << kind << ", " << i;
      }
    }
  }
}

TEST(NearestNeighbors, ContainNoPointTwice) {
  for (const auto& [kind, points] : clouds_of_all_kinds()) {
    const NeighborLists lists = nearest_neighbors(points, 10);
    for (Index i = 0; i < points.rows(); ++i) {
      std::vector<Index> neighbors = list(lists.of(i));
      std::sort(neighbors.begin(), neighbors.end());
      EXPECT_EQ(std::adjacent_find(neighbors.begin(), neighbors.end()), neighbors.end()) << kind;
    }
  }
}

TEST(NearestNeighbors, OfCountZeroAreNone) {
  const NeighborLists lists = nearest_neighbors(random_points(1, 20), 0);
  EXPECT_EQ(lists.size(), 20U);
  EXPECT_TRUE(lists.neighbors.empty());
}

TEST(CellList, FindsTheSameNearestPointAsBruteForce) {
  const Points points = random_points(4, 400);
  const CellList cells(points, 0.01F);
  const Points queries = random_points(5, 200, 0.15);
  for (Index q = 0; q < queries.rows(); ++q) {
    const Eigen::Vector3f query = queries.row(q).transpose();
    std::pair<Index, float> expected{CellList::none, 0.04F * 0.04F};
    for (Index i = 0; i < points.rows(); ++i) {
      const float d = squared_distance(points, i, query);
      if (d < expected.second) expected = {i, d};
    }
    EXPECT_EQ(cells.nearest(query, 0.04F).first, expected.first);
  }
}

TEST(CellList, SearchesAnExtentThatCellsOfTheGivenSizeCannotCover) {
  Points points = random_points(4, 400);
  points.row(0) << 7.0F, -9.0F, 6.0F;  // 2^28 cells of 1 cm and more
  const CellList cells(points, 0.01F);
  EXPECT_EQ(cells.nearest({7.01F, -9.0F, 6.0F}, 0.02F).first, 0U);
  for (Index i = 1; i < 400; ++i)
    EXPECT_EQ(cells.nearest(points.row(i).transpose(), 0.01F).first, i);
}

TEST(CellList, RefusesAnExtentInMillimetres) {
  const Points points = random_points(4, 400) * 1e4F;
  EXPECT_THROW(CellList(points, 0.01F), InputError);
}

TEST(CellList, BreaksTiesByTheLowerIndex) {
  const Points points = random_points(4, 1).replicate(5, 1);
  const CellList cells(points, 0.01F);
  EXPECT_EQ(cells.nearest(points.row(0).transpose(), 0.01F), (std::pair<Index, float>{0, 0.0F}));
}

TEST(CellList, FindsNothingInAnEmptyCloudOrFarFromIt) {
  EXPECT_EQ(CellList(Points(0, 3), 0.01F).nearest(Eigen::Vector3f::Zero(), 1.0F).first,
            CellList::none);
  const CellList cells(random_points(1, 50), 0.01F);
  EXPECT_EQ(cells.nearest(Eigen::Vector3f::Constant(9.0F), 0.02F).first, CellList::none);
}

TEST(CellList, FindsNothingForAQueryThatReachesExactlyTheLastBorder) {
  Points points(2, 3);
  points << 0.0F, 0.0F, 0.0F, 3.0F, 3.0F, 3.0F;
  const CellList cells(points, 1.0F);  // borders at 0 to 4
  for (const float radius : {0.25F, 0.5F, 0.75F}) {
    float coordinate = 4.0F + (radius + 1e-3F);  // the search allows for rounding by 1e-3 cells
    for (int step = 0; step < 4; ++step) coordinate = std::nextafter(coordinate, 0.0F);
    for (int step = 0; step < 9; ++step, coordinate = std::nextafter(coordinate, 9.0F)) {
      for (int axis = 0; axis < 3; ++axis) {
        Eigen::Vector3f query(3.0F, 3.0F, 3.0F);
        query[axis] = coordinate;
        EXPECT_EQ(cells.nearest(query, radius).first, CellList::none);
      }
    }
  }
}

TEST(CellList, RefusesPointsThatAreNotFinite) {
  Points points = random_points(1, 10);
  points(3, 1) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(CellList(points, 0.01F), InputError);
  points(3, 1) = std::numeric_limits<float>::infinity();
  EXPECT_THROW(CellList(points, 0.01F), InputError);
}

TEST(CellList, RefusesAnExtentThatNoGridCovers) {
  Points points = random_points(1, 10);
  points(3, 1) = 3e38F;
  EXPECT_THROW(CellList(points, 0.01F), InputError);
  points(4, 1) = -3e38F;
  EXPECT_THROW(CellList(points, 0.01F), InputError);
}

TEST(CellList, RefusesACellWithoutASize) {
  for (const float size : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROW(CellList(random_points(1, 10), size), InputError);
    EXPECT_THROW(CellList(random_points(1, 1), size), InputError);
  }
}

TEST(Neighbors, AreTheSameForAnyNumberOfThreads) {
  const Points points = random_points(2, 5000);
  std::vector<NeighborLists> lists;
  for (const std::size_t threads : {1U, 2U, 8U}) {
    lists.push_back(testing::with_threads(threads, [&] { return nearest_neighbors(points, 10); }));
  }
  EXPECT_EQ(lists[0].neighbors, lists[1].neighbors);
  EXPECT_EQ(lists[0].neighbors, lists[2].neighbors);
}

}  // namespace
}  // namespace symscene
