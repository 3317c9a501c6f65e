#include "symscene/evaluation/mask_metrics.hpp"

#include <gtest/gtest.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

PointCloud points_on_a_line(std::initializer_list<float> xs) {
  PointCloud cloud;
  cloud.positions = Points::Zero(static_cast<Eigen::Index>(xs.size()), 3);
  Eigen::Index i = 0;
  for (const float x : xs) cloud.positions(i++, 0) = x;
  return cloud;
}

SceneTruth truth_of(std::initializer_list<PointIndices> masks) {
  SceneTruth truth;
  for (const PointIndices& mask : masks) {
    truth.objects.emplace_back();
    truth.objects.back().points = mask;
  }
  return truth;
}

TEST(TransferMasks, PointsTakeTheLabelOfTheNearestPointWithinReach) {
  const PointCloud labeled = points_on_a_line({0.0F, 0.1F, 0.2F});
  const PointCloud target = points_on_a_line({0.004F, 0.098F, 0.15F, 0.203F});
  const auto masks = transfer_masks(labeled, truth_of({{1}, {0}}), target);
  ASSERT_EQ(masks.size(), 2U);
  EXPECT_EQ(masks[0], PointIndices({1}));
  EXPECT_EQ(masks[1], PointIndices({0}));  // 0.15 is out of reach, 0.203 is near no object
}

TEST(TransferMasks, OntoTheSameCloudChangesNothing) {
  const PointCloud cloud = points_on_a_line({0.0F, 0.02F, 0.04F, 0.06F});
  const auto masks = transfer_masks(cloud, truth_of({{0, 2}, {1}}), cloud);
  EXPECT_EQ(masks[0], PointIndices({0, 2}));
  EXPECT_EQ(masks[1], PointIndices({1}));
}

TEST(TransferMasks, RefusesIndicesThatTheCloudDoesNotHave) {
  const PointCloud cloud = points_on_a_line({0.0F});
  EXPECT_THROW(transfer_masks(cloud, truth_of({{1}}), cloud), InputError);
}

TEST(OverlapMatrix, HoldsIntersectionOverUnion) {
  const OverlapMatrix overlaps = overlap_matrix({{0, 1, 2, 3}, {4, 5}}, {{0, 1}, {3, 4, 5}, {9}});
  ASSERT_EQ(overlaps.rows(), 2);
  ASSERT_EQ(overlaps.cols(), 3);
  EXPECT_DOUBLE_EQ(overlaps(0, 0), 0.5);
  EXPECT_DOUBLE_EQ(overlaps(0, 1), 1.0 / 6.0);
  EXPECT_DOUBLE_EQ(overlaps(1, 1), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(overlaps(1, 2), 0.0);
}

TEST(MaskScore, CountsAsEquationsFourFourteenAndFifteen) {
  OverlapMatrix overlaps(3, 4);
  overlaps << 0.95, 0.1, 0.0, 0.92,  // found twice: once right, but both returned
      0.0, 0.8, 0.0, 0.0,            //
      0.0, 0.0, 0.3, 0.0;
  const DetectionCounts strict = mask_detections(overlaps, 0.9);
  EXPECT_EQ(strict.correct, 1U);
  EXPECT_DOUBLE_EQ(strict.precision(), 0.25);
  EXPECT_DOUBLE_EQ(strict.recall(), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(strict.f_measure(), 2.0 / 7.0);
  EXPECT_EQ(mask_detections(overlaps, 0.75).correct, 2U);
}

TEST(MaskScore, TheScoreOfSeveralScenesIsThatOfTheirSummedCounts) {
  DetectionCounts total{1, 2, 4};
  total += DetectionCounts{3, 3, 4};
  EXPECT_DOUBLE_EQ(total.precision(), 0.8);
  EXPECT_DOUBLE_EQ(total.recall(), 0.5);
}

TEST(MaskScore, WithoutFoundMasksRecallIsZero) {
  const OverlapMatrix overlaps = overlap_matrix({{0, 1}}, {});
  EXPECT_DOUBLE_EQ(mask_detections(overlaps, 0.9).recall(), 0.0);
}

}  // namespace
}  // namespace symscene
