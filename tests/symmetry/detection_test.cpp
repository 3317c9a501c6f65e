#include <gtest/gtest.h>

#include "surfaces.hpp"
#include "symmetry/axis_quality.hpp"
#include "symmetry/segment_axis.hpp"
#include "symscene/core/error.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"
#include "symscene/symmetry/rotational_detection.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using testing::all_of;
using testing::all_seen;
using testing::moved;
using testing::nothing_known;

TEST(RotationalDetection, MovesWithTheScene) {
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const Eigen::Isometry3d motion = testing::random_motion(generator);
    const PointCloud cloud = moved(testing::seen_from(testing::vase(), {1.0F, 1.0F, 1.0F}), motion);
    const RotationalDetection detection =
        detect_rotational(cloud, {all_of(cloud)}, nothing_known(cloud), std::nullopt);
    ASSERT_EQ(detection.candidates.size(), 1U) << "seed " << seed;
    const RotationAxis truth{motion.translation(), motion.linear() * Eigen::Vector3d::UnitZ()};
    const SymmetryDifference apart =
        difference(detection.candidates[0].axis, truth, centroid(cloud.positions));
    EXPECT_LT(apart.angle, radians(1.5));
    EXPECT_LT(apart.distance, 0.003);
  }
}

TEST(RotationalDetection, RefusesAxesThatRotateTheSurfaceIntoFreeSpace) {
  const PointCloud half = testing::seen_from(testing::vase(), {1.0F, 0.0F, 0.3F});
  EXPECT_EQ(
      detect_rotational(half, {all_of(half)}, nothing_known(half), std::nullopt).candidates.size(),
      1U);
  EXPECT_TRUE(
      detect_rotational(half, {all_of(half)}, all_seen(half), std::nullopt).candidates.empty());
}

TEST(RotationalDetection, RefusesABoxAndAFlatPatch) {
  const PointCloud box = testing::box({0.1, 0.15, 0.2});
  EXPECT_TRUE(
      detect_rotational(box, {all_of(box)}, nothing_known(box), std::nullopt).candidates.empty());
  const PointCloud patch = testing::seen_from(box, {0.0F, 0.0F, 0.21F});
  EXPECT_TRUE(detect_rotational(patch, {all_of(patch)}, nothing_known(patch), std::nullopt)
                  .candidates.empty());
}

TEST(RotationalDetection, MergesTheCandidatesOfTwoSegments) {
  const PointCloud cloud = testing::vase();
  PointIndices lower;
  PointIndices upper;
  for (Index i = 0; i < cloud.size(); ++i)
    (cloud.positions(i, 2) < 0.1F ? lower : upper).push_back(i);
  EXPECT_EQ(detect_rotational(cloud, {lower, upper}, nothing_known(cloud), std::nullopt)
                .candidates.size(),
            1U);
}

TEST(SegmentAxis, NamesTheBoundThatTheBestAxisFails) {
  const RotationalDetectionOptions options;
  const auto judged = [&](const PointCloud& cloud, const DistanceField& field) {
    return segment_axis(cloud, all_of(cloud), field, std::nullopt, options).judgement;
  };
  const PointCloud vase = testing::vase();
  const PointCloud half = testing::seen_from(vase, {1.0F, 0.0F, 0.3F});
  const PointCloud box = testing::box({0.1, 0.15, 0.2});
  const PointCloud patch = testing::seen_from(box, {0.0F, 0.0F, 0.21F});
  PointIndices narrow;
  for (Index i = 0; i < vase.size(); ++i) {
    if (vase.positions(i, 0) > 1.5F * std::abs(vase.positions(i, 1))) narrow.push_back(i);
  }
  const PointCloud sector = select(vase, narrow);
  EXPECT_EQ(judged(half, nothing_known(half)).outcome, AxisOutcome::accepted);
  EXPECT_EQ(judged(half, all_seen(half)).outcome, AxisOutcome::occlusion);
  EXPECT_EQ(judged(box, nothing_known(box)).outcome, AxisOutcome::symmetry);
  EXPECT_EQ(judged(patch, nothing_known(patch)).outcome, AxisOutcome::perpendicularity);
  EXPECT_EQ(judged(sector, nothing_known(sector)).outcome, AxisOutcome::coverage);
  EXPECT_EQ(judged(select(vase, PointIndices{0, 1, 2}), nothing_known(vase)).outcome,
            AxisOutcome::no_fit);
  const AxisJudgement rejected = judged(box, nothing_known(box));
  EXPECT_GE(rejected.value, rejected.bound);
  EXPECT_EQ(rejected.bound, options.max_symmetry_residual);
}

TEST(AngularCoverage, IsTheTurnThatIsSeen) {
  const PointCloud cloud = testing::vase();
  const RotationAxis axis;
  EXPECT_GT(angular_coverage(cloud.positions, axis), 0.97);
  PointIndices quarter;
  for (Index i = 0; i < cloud.size(); ++i) {
    if (cloud.positions(i, 0) > 0.0F && cloud.positions(i, 1) > 0.0F) quarter.push_back(i);
  }
  EXPECT_NEAR(angular_coverage(select(cloud, quarter).positions, axis), 0.25, 0.01);
  EXPECT_EQ(angular_coverage(Points(0, 3), axis), 0.0);
}

TEST(ReflectionalDetection, FindsTheThreePlanesOfABoxAndMovesWithIt) {
  const PointCloud box = testing::box({0.1, 0.16, 0.22});
  const Eigen::Vector3d centre(0.0, 0.0, 0.11);
  for (const std::uint32_t seed : {1U, 2U}) {
    std::mt19937 generator(seed);
    const Eigen::Isometry3d motion = testing::random_motion(generator);
    const PointCloud cloud = moved(box, motion);
    const ReflectionalDetection detection =
        detect_reflectional(cloud, {all_of(cloud)}, all_seen(cloud), std::nullopt);
    for (int axis = 0; axis < 3; ++axis) {
      const ReflectionPlane truth{motion * centre, motion.linear() * Eigen::Vector3d::Unit(axis)};
      const bool found =
          std::any_of(detection.candidates.begin(), detection.candidates.end(), [&](const auto& c) {
            const SymmetryDifference apart = difference(c.plane, truth, motion * centre);
            return apart.angle < radians(2.0) && apart.distance < 0.003;
          });
      EXPECT_TRUE(found) << "seed " << seed << " axis " << axis;
    }
  }
}

TEST(ReflectionalDetection, ListsNoPlaneTwice) {
  const PointCloud cloud = testing::box({0.1, 0.16, 0.22});
  const ReflectionalDetectionOptions options;
  const ReflectionalDetection detection = detect_reflectional(cloud, {all_of(cloud), all_of(cloud)},
                                                              nothing_known(cloud), std::nullopt);
  ASSERT_GT(detection.candidates.size(), 1U);
  const Eigen::Vector3d here = centroid(cloud.positions);
  for (std::size_t i = 0; i < detection.candidates.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const SymmetryDifference apart =
          difference(detection.candidates[i].plane, detection.candidates[j].plane, here);
      EXPECT_FALSE(apart.angle < options.same_angle && apart.distance < options.same_distance);
    }
  }
}

TEST(Detection, IsTheSameForAnyNumberOfThreads) {
  const PointCloud cloud = testing::vase();
  const DistanceField field = nothing_known(cloud);
  const std::vector<PointIndices> segments(6, all_of(cloud));
  std::vector<RotationAxis> axes;
  std::vector<std::vector<ReflectionalCandidate>> planes;
  for (const std::size_t threads : {1U, 8U}) {
    testing::with_threads(threads, [&] {
      axes.push_back(detect_rotational(cloud, segments, field, std::nullopt).candidates.at(0).axis);
      planes.push_back(detect_reflectional(cloud, segments, field, std::nullopt).candidates);
    });
  }
  EXPECT_EQ(axes[0].point, axes[1].point);
  EXPECT_EQ(axes[0].direction, axes[1].direction);
  ASSERT_FALSE(planes[0].empty());
  ASSERT_EQ(planes[0].size(), planes[1].size());
  for (std::size_t i = 0; i < planes[0].size(); ++i) {
    EXPECT_EQ(planes[0][i].plane.normal, planes[1][i].plane.normal);
    EXPECT_EQ(planes[0][i].plane.point, planes[1][i].plane.point);
  }
}

TEST(Detection, OfNothingFindsNothing) {
  const PointCloud cloud = testing::vase();
  EXPECT_TRUE(detect_rotational(cloud, {}, nothing_known(cloud), std::nullopt).candidates.empty());
  EXPECT_TRUE(
      detect_reflectional(cloud, {}, nothing_known(cloud), std::nullopt).candidates.empty());
}

TEST(Detection, RefusesInvalidOptions) {
  RotationalDetectionOptions rotational;
  rotational.max_angle = 0.0;
  EXPECT_THROW(rotational.validate(), InputError);
  ReflectionalDetectionOptions reflectional;
  reflectional.placement.azimuth_steps = 0;
  EXPECT_THROW(reflectional.validate(), InputError);
}

}  // namespace
}  // namespace symscene
