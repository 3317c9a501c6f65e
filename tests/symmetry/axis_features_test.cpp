#include "symmetry/axis_features.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "surfaces.hpp"
#include "symmetry/axis_quality.hpp"
#include "symmetry/sphere_fit.hpp"
#include "symmetry/symmetry_score.hpp"

namespace symscene {
namespace {

const Plane table_below{Eigen::Vector3d::UnitZ(), 0.0};

AxisFeatures features_of(const PointCloud& cloud, const RotationAxis& axis,
                         const std::optional<Plane>& below = table_below) {
  const AxisQuality quality =
      axis_quality(cloud, axis, testing::nothing_known(cloud), RotationalDetectionOptions{});
  return axis_features(cloud, axis, quality, below);
}

PointCloud ball() {
  const std::array parts{Ellipsoid{{0.0, 0.0, 0.1}, {0.05, 0.05, 0.05}}};
  return testing::as_cloud(make_mirrored_body(parts, 0.001, 0.005));
}

TEST(AxisFeatures, OfAVaseAndItsAxis) {
  const AxisFeatures features = features_of(testing::vase(), {});
  EXPECT_LT(features.symmetry_residual, 0.01);
  EXPECT_LT(features.residual, 0.001);  // its sides lean, within a ring too
  EXPECT_NEAR(features.height, 0.2, 0.003);
  EXPECT_NEAR(features.radius, 0.07, 0.003);
  EXPECT_LT(features.off_centre, 0.02);
  EXPECT_NEAR(features.coverage, 1.0, 0.05);
  EXPECT_NEAR(features.upright, 1.0, 1e-9);
  EXPECT_GT(features.along, 0.03);  // its bottom and its top
}

TEST(AxisFeatures, OfAnAxisBesideTheVase) {
  const AxisFeatures beside = features_of(testing::vase(), {{0.02, 0.0, 0.0}, {0.0, 0.0, 1.0}});
  EXPECT_GT(beside.residual, 0.008);
  EXPECT_GT(beside.off_centre, 0.15);
  EXPECT_EQ(features_of(testing::vase(), {}, std::nullopt).upright, -1.0);
}

TEST(AxisFeatures, OfABall) {
  const AxisFeatures features = features_of(ball(), {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  EXPECT_LT(features.roundness, 0.01);
  EXPECT_NEAR(features.upright, 0.0, 1e-9);
  EXPECT_GT(features_of(testing::vase(), {}).roundness, 0.05);
}

TEST(AxisFeatures, OfPointsOffASphere) {
  Points one(1, 3);
  one << 1.0F, 2.0F, 3.0F;
  EXPECT_EQ(distance_off_sphere(one), 1.0);
  Points flat = ball().positions;
  flat.col(2).setConstant(0.3F);
  EXPECT_GT(distance_off_sphere(flat), 0.1);
  EXPECT_EQ(distance_off_sphere(Points(0, 3)), 1.0);
  EXPECT_LT(distance_off_sphere(ball().positions), 0.01);
}

TEST(AxisScore, IsAProbabilityForAnyFeatures) {
  for (const double value : {-1e300, 0.0, 0.5, 1e300, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    AxisFeatures features;
    AxisFeatures::visit_fields(features, [&](const char*, double& field) { field = value; });
    EXPECT_GT(axis_probability(features), 0.0);
    EXPECT_LT(axis_probability(features), 1.0);
  }
}

TEST(AxisScore, IsHighForTheAxisOfABodyOfRevolution) {
  EXPECT_GT(axis_probability(features_of(testing::vase(), {})), 0.8);
}

// The model was fitted to axes within ObjectSymmetryOptions, as these are: others never reach it.

/// The axis of a bottle that is seen from one side.
AxisFeatures bottle() {
  return {.symmetry_residual = 0.0005,
          .perpendicularity = 0.08,
          .coverage = 0.66,
          .occlusion_residual = 0.0,
          .residual = 0.0006,
          .height = 0.26,
          .radius = 0.034,
          .off_centre = 0.46,
          .across = 0.71,
          .along = 0.0,
          .roundness = 0.24,
          .upright = 1.0,
          .size = 6.6};
}

/// The axis of a round limb of a toy that lies on the table.
AxisFeatures limb() {
  return {.symmetry_residual = 0.03,
          .perpendicularity = 0.2,
          .coverage = 0.3,
          .occlusion_residual = 0.02,
          .residual = 0.004,
          .height = 0.1,
          .radius = 0.05,
          .off_centre = 0.6,
          .across = 0.4,
          .along = 0.1,
          .roundness = 0.1,
          .upright = 0.3,
          .size = 6.5};
}

TEST(AxisScore, IsHighForABottleAndLowForALimb) {
  EXPECT_GT(axis_probability(bottle()), 0.95);
  EXPECT_LT(axis_probability(limb()), 0.2);
}

}  // namespace
}  // namespace symscene
