#include "core/stray_points.hpp"

#include <gtest/gtest.h>

#include "core/random_clouds.hpp"

namespace symscene {
namespace {

/// By comparing all pairs of points.
PointIndices by_brute_force(const Points& points, float radius, int min_neighbors) {
  PointIndices kept;
  for (Index i = 0; i < points.rows(); ++i) {
    int others = 0;
    for (Index j = 0; j < points.rows(); ++j)
      others += j != i && (points.row(i) - points.row(j)).squaredNorm() <= radius * radius ? 1 : 0;
    if (others >= min_neighbors) kept.push_back(i);
  }
  return kept;
}

TEST(StrayPoints, AreThoseThatBruteForceFinds) {
  for (const auto& [name, points] : testing::clouds_of_all_kinds()) {
    if (points.rows() == 0) continue;
    for (const int min_neighbors : {0, 1, 3})
      EXPECT_EQ(points_with_neighbors(points, 0.02, min_neighbors),
                by_brute_force(points, 0.02F, min_neighbors))
          << name;
  }
}

}  // namespace
}  // namespace symscene
