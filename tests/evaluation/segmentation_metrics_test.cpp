#include "symscene/evaluation/segmentation_metrics.hpp"

#include <gtest/gtest.h>

#include "evaluation/assignment.hpp"
#include "index_range.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Ten points in a row, 5 mm apart, each a neighbour of the next.
NeighborLists row_of_ten() {
  Points points = Points::Zero(10, 3);
  for (Eigen::Index i = 0; i < 10; ++i) points(i, 0) = 0.005F * static_cast<float>(i);
  return radius_neighbors(points, 0.006F);
}

OverlapMatrix matrix(Eigen::Index rows, Eigen::Index columns, std::initializer_list<double> v) {
  OverlapMatrix gains(rows, columns);
  const double* next = v.begin();
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < columns; ++j) gains(i, j) = *next++;
  }
  return gains;
}

TEST(AssignMasks, FindsTheGreatestSumWhereGreedyAssignmentFails) {
  const auto pairs = assign_masks(matrix(2, 2, {0.9, 0.8, 0.8, 0.1}));
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0].found, 1U);
  EXPECT_EQ(pairs[1].found, 0U);
}

TEST(AssignMasks, AcceptsMatricesOfAnyShape) {
  const auto wide = assign_masks(matrix(1, 3, {0.1, 0.7, 0.3}));
  ASSERT_EQ(wide.size(), 1U);
  EXPECT_EQ(wide[0].found, 1U);
  const auto tall = assign_masks(matrix(3, 2, {0.5, 0.6, 0.0, 0.9, 0.8, 0.0}));
  ASSERT_EQ(tall.size(), 2U);
  EXPECT_EQ(tall[0].truth, 1U);
  EXPECT_EQ(tall[0].found, 1U);
  EXPECT_EQ(tall[1].truth, 2U);
  EXPECT_EQ(tall[1].found, 0U);
  EXPECT_TRUE(assign_masks(OverlapMatrix(0, 4)).empty());
  EXPECT_TRUE(assign_masks(matrix(1, 1, {0.0})).empty());
}

/// The best sum by trying every order of the columns.
double best_sum(const OverlapMatrix& gains) {
  std::vector<Eigen::Index> order;
  for (Eigen::Index j = 0; j < gains.cols(); ++j) order.push_back(j);
  double best = 0.0;
  do {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < gains.rows(); ++i)
      sum += gains(i, order[static_cast<std::size_t>(i)]);
    best = std::max(best, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(AssignMasks, IsAsGoodAsExhaustiveSearch) {
  std::srand(7);
  for (int trial = 0; trial < 30; ++trial) {
    const OverlapMatrix gains = (OverlapMatrix::Random(4, 5).array() + 1.0).matrix();
    double sum = 0.0;
    for (const MaskPair& pair : assign_masks(gains)) sum += pair.overlap;
    EXPECT_NEAR(sum, best_sum(gains), 1e-12);
  }
}

TEST(LabelPoints, GivesAPointToTheFirstMaskThatHoldsIt) {
  EXPECT_EQ(label_points({{1, 2}, {0, 1}}, 4), (std::vector<Index>{1, 0, 0, unlabeled}));
  EXPECT_THROW(label_points({{4}}, 4), InputError);
}

TEST(SegmentationMetrics, BoundariesOnePointApartMatch) {
  const SegmentationMetrics m =
      segmentation_metrics({testing::index_range(0, 5), testing::index_range(5, 10)},
                           {testing::index_range(0, 6), testing::index_range(6, 10)}, row_of_ten());
  EXPECT_DOUBLE_EQ(m.overlap_precision, 0.9);
  EXPECT_DOUBLE_EQ(m.overlap_recall, 0.9);
  EXPECT_DOUBLE_EQ(m.overlap_f, 0.9);
  EXPECT_DOUBLE_EQ(m.boundary_precision, 1.0);
  EXPECT_DOUBLE_EQ(m.boundary_recall, 1.0);
  EXPECT_DOUBLE_EQ(m.found_75, 1.0);
}

TEST(SegmentationMetrics, BoundariesTwoPointsApartDoNotMatch) {
  const SegmentationMetrics m =
      segmentation_metrics({testing::index_range(0, 5), testing::index_range(5, 10)},
                           {testing::index_range(0, 7), testing::index_range(7, 10)}, row_of_ten());
  EXPECT_DOUBLE_EQ(m.overlap_precision, 0.8);
  EXPECT_DOUBLE_EQ(m.boundary_f, 0.0);
  EXPECT_DOUBLE_EQ(m.found_75, 1.0);  // 10/12, and 6/8 is just enough
}

TEST(SegmentationMetrics, ExtraMasksReducePrecisionAndMissedMasksReduceRecall) {
  // One true object of five points at an edge of the cloud; found whole, with a stray mask.
  const SegmentationMetrics stray =
      segmentation_metrics({testing::index_range(0, 5)},
                           {testing::index_range(0, 5), testing::index_range(7, 9)}, row_of_ten());
  EXPECT_DOUBLE_EQ(stray.overlap_precision, 5.0 / 7.0);
  EXPECT_DOUBLE_EQ(stray.overlap_recall, 1.0);
  const SegmentationMetrics missed =
      segmentation_metrics({testing::index_range(0, 5), testing::index_range(7, 9)},
                           {testing::index_range(0, 5)}, row_of_ten());
  EXPECT_DOUBLE_EQ(missed.overlap_recall, 5.0 / 7.0);
  EXPECT_DOUBLE_EQ(missed.found_75, 0.5);
}

TEST(SegmentationMetrics, PointsWithoutLabelMakeNoBoundary) {
  // One object of which point 4 was not labelled, found whole.
  const PointIndices labelled{0, 1, 2, 3, 5, 6, 7, 8, 9};
  const SegmentationMetrics alone =
      segmentation_metrics({labelled}, {testing::index_range(0, 10)}, row_of_ten());
  EXPECT_FALSE(alone.has_boundary());
  // Two such objects side by side: the boundary is between them alone.
  const SegmentationMetrics two =
      segmentation_metrics({{0, 2, 3, 4}, {5, 6, 7, 9}},
                           {testing::index_range(0, 5), testing::index_range(5, 10)}, row_of_ten());
  EXPECT_TRUE(two.has_boundary());
  EXPECT_DOUBLE_EQ(two.boundary_f, 1.0);
}

TEST(SegmentationMetrics, BoundariesOfExtraAndMissedMasksCount) {
  // A third mask that splits the second object; the boundary between the objects is exact.
  const SegmentationMetrics extra = segmentation_metrics(
      {testing::index_range(0, 5), testing::index_range(5, 10)},
      {testing::index_range(0, 5), testing::index_range(5, 8), testing::index_range(8, 10)},
      row_of_ten());
  EXPECT_DOUBLE_EQ(extra.boundary_precision, 0.5);  // 4 and 5 of 4, 5, 7, 8
  EXPECT_DOUBLE_EQ(extra.boundary_recall, 1.0);
  const SegmentationMetrics missed = segmentation_metrics(
      {testing::index_range(0, 5), testing::index_range(5, 8), testing::index_range(8, 10)},
      {testing::index_range(0, 5), testing::index_range(5, 10)}, row_of_ten());
  EXPECT_DOUBLE_EQ(missed.boundary_precision, 1.0);
  EXPECT_DOUBLE_EQ(missed.boundary_recall, 0.5);
}

TEST(SegmentationMetrics, TheMeanOfBoundariesIsOverScenesThatHaveOne) {
  const SegmentationMetrics touching =
      segmentation_metrics({testing::index_range(0, 5), testing::index_range(5, 10)},
                           {testing::index_range(0, 7), testing::index_range(7, 10)}, row_of_ten());
  // One object is all of the cloud: it has no boundary, and a stray mask would have one.
  const SegmentationMetrics alone =
      segmentation_metrics({testing::index_range(0, 10)},
                           {testing::index_range(0, 8), testing::index_range(8, 10)}, row_of_ten());
  EXPECT_DOUBLE_EQ(touching.with_boundary, 1.0);
  EXPECT_DOUBLE_EQ(alone.with_boundary, 0.0);
  SegmentationMetrics sum;
  sum +=
      segmentation_metrics({testing::index_range(0, 5), testing::index_range(5, 10)},
                           {testing::index_range(0, 5), testing::index_range(5, 10)}, row_of_ten());
  sum += touching;
  sum += alone;
  EXPECT_DOUBLE_EQ(sum.mean(3).boundary_f, 0.5);
  EXPECT_DOUBLE_EQ(sum.mean(3).overlap_f, (1.0 + 0.8 + 0.8) / 3.0);
  SegmentationMetrics none;
  none += alone;
  EXPECT_DOUBLE_EQ(none.mean(1).boundary_f, 0.0);
}

TEST(SegmentationMetrics, WithoutFoundMasksPrecisionIsOneAndRecallZero) {
  const SegmentationMetrics m =
      segmentation_metrics({testing::index_range(0, 5)}, {}, row_of_ten());
  EXPECT_DOUBLE_EQ(m.overlap_precision, 1.0);
  EXPECT_DOUBLE_EQ(m.overlap_recall, 0.0);
  EXPECT_DOUBLE_EQ(m.overlap_f, 0.0);
  const SegmentationMetrics nothing = segmentation_metrics({}, {}, row_of_ten());
  EXPECT_DOUBLE_EQ(nothing.overlap_f, 1.0);
  EXPECT_DOUBLE_EQ(nothing.boundary_f, 1.0);
}

/// An image of 40 by 10 pixels with a label for the columns [begin, end) of all rows.
struct Stripe {
  std::size_t begin;
  std::size_t end;
  std::uint16_t label;
};

std::vector<std::uint16_t> stripes(std::initializer_list<Stripe> all) {
  std::vector<std::uint16_t> image(400, 0);
  for (const Stripe& stripe : all) {
    for (std::size_t i = 0; i < image.size(); ++i) {
      if (i % 40 >= stripe.begin && i % 40 < stripe.end) image[i] = stripe.label;
    }
  }
  return image;
}

TEST(PixelMetrics, AreThoseCountedByHand) {
  // Objects of 10 and 20 columns; the first is found whole, of the second 12 columns with 4 others.
  const auto truth = stripes({{0, 10, 3}, {10, 30, 7}});
  const auto found = stripes({{0, 10, 1}, {18, 34, 2}});
  const SegmentationMetrics m = pixel_metrics(truth, found, 40, 10);
  EXPECT_DOUBLE_EQ(m.overlap_precision, 22.0 / 26.0);
  EXPECT_DOUBLE_EQ(m.overlap_recall, 22.0 / 30.0);
  EXPECT_DOUBLE_EQ(m.overlap_f, 44.0 / 56.0);
  // Columns 9 | 18, 33 against 9 | 10, 29: only the first matches, within one pixel.
  EXPECT_DOUBLE_EQ(m.boundary_precision, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(m.boundary_recall, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(m.found_75, 0.5);  // the second has F = 24 / 36
}

TEST(PixelMetrics, ABoundaryMatchesWithinItsDisc) {
  // 0.3 % of the diagonal of 40 by 10 pixels is below one pixel.
  const auto truth = stripes({{0, 20, 1}});
  EXPECT_DOUBLE_EQ(pixel_metrics(truth, stripes({{0, 21, 1}}), 40, 10).boundary_f, 1.0);
  EXPECT_DOUBLE_EQ(pixel_metrics(truth, stripes({{0, 22, 1}}), 40, 10).boundary_f, 0.0);
}

TEST(PixelMetrics, AnF75OfExactlyThreeQuartersIsNotEnough) {
  // 2 · 12 / (12 + 20) = 0.75.
  const auto truth = stripes({{0, 20, 1}});
  EXPECT_DOUBLE_EQ(pixel_metrics(truth, stripes({{0, 12, 1}}), 40, 10).found_75, 0.0);
  EXPECT_DOUBLE_EQ(pixel_metrics(truth, stripes({{0, 13, 1}}), 40, 10).found_75, 1.0);
}

TEST(PixelMetrics, DoNotDependOnTheNumbersOfLabels) {
  const auto truth = stripes({{0, 10, 1}, {10, 30, 2}});
  const auto found = stripes({{0, 14, 1}, {14, 30, 2}});
  const auto other = stripes({{0, 14, 900}, {14, 30, 40}});
  EXPECT_DOUBLE_EQ(pixel_metrics(truth, found, 40, 10).overlap_f,
                   pixel_metrics(truth, other, 40, 10).overlap_f);
}

TEST(PixelMetrics, OfNothingFoundArePrecisionOneAndRecallZero) {
  const SegmentationMetrics m = pixel_metrics(stripes({{0, 10, 1}}), stripes({}), 40, 10);
  EXPECT_DOUBLE_EQ(m.overlap_precision, 1.0);
  EXPECT_DOUBLE_EQ(m.overlap_recall, 0.0);
  EXPECT_DOUBLE_EQ(m.found_75, 0.0);
  EXPECT_DOUBLE_EQ(pixel_metrics(stripes({}), stripes({}), 40, 10).overlap_f, 1.0);
  EXPECT_THROW(pixel_metrics(stripes({}), stripes({}), 41, 10), InputError);
}

}  // namespace
}  // namespace symscene
