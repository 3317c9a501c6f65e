#include "segmentation/removal.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace symscene {
namespace {

/// A chain of ten points with two segments, the first five and the last five.
Workspace chain() {
  Workspace space;
  space.cloud.positions = Points::Zero(10, 3);
  space.cloud.normals = Points::Zero(10, 3);
  for (Index i = 0; i < 10; ++i) space.cloud.positions(i, 0) = static_cast<float>(i);
  for (Index i = 0; i + 1 < 10; ++i) space.edges.push_back({i, i + 1, static_cast<float>(i)});
  space.segments = {{0, 1, 2, 3, 4}, {5, 6, 7, 8, 9}};
  return space;
}

RemovalOptions options_for_few_points() {
  return {.bounds = {1.0, 1.0, 1.0, 1}, .min_confidence = 0.5, .min_segment_size = 3};
}

Hypothesis hypothesis(PointIndices points, double residual) {
  return {std::move(points), {residual, residual, residual}, {}, {}};
}

TEST(Removal, LeavesWhatNoCertainHypothesisHolds) {
  const Workspace space = chain();
  const Remainder rest = without_rotational_objects(
      space, {hypothesis({0, 1, 2}, 0.1), hypothesis({8, 9}, 0.9)}, options_for_few_points());
  EXPECT_EQ(rest.original, (PointIndices{3, 4, 5, 6, 7, 8, 9}));
  ASSERT_EQ(rest.cloud.size(), 7U);
  ASSERT_EQ(rest.edges.size(), 6U);
  for (const WeightedEdge& edge : rest.edges) {
    EXPECT_EQ(rest.original[edge.a] + 1, rest.original[edge.b]);
    EXPECT_EQ(edge.weight, static_cast<float>(rest.original[edge.a]));
  }
  ASSERT_EQ(rest.segments.size(), 1U) << "a segment with two points left is dropped";
  EXPECT_EQ(rest.in_whole(rest.segments[0]), (PointIndices{5, 6, 7, 8, 9}));
}

TEST(Removal, LeavesTheWholeSceneIfNoHypothesisIsWithinTheBounds) {
  const Workspace space = chain();
  RemovalOptions options = options_for_few_points();
  options.bounds.min_size = 4;
  const Remainder rest = without_rotational_objects(space, {hypothesis({0, 1, 2}, 0.0)}, options);
  EXPECT_EQ(rest.original, testing::all_of(space.cloud));
  EXPECT_EQ(rest.segments, space.segments);
}

}  // namespace
}  // namespace symscene
