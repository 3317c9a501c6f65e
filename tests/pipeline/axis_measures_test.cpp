#include "symscene/pipeline/axis_measures.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "surfaces.hpp"
#include "symscene/pipeline/symmetry_score.hpp"
#include "symscene/symmetry/sphere_fit.hpp"

namespace symscene {
namespace {

const Plane table{Eigen::Vector3d::UnitZ(), 0.0};

AxisMeasures measure(const PointCloud& cloud, const RotationAxis& axis,
                     const std::optional<Plane>& below = table) {
  const RotationalScores scores =
      rotational_scores(cloud, axis, testing::nothing_known(cloud), RotationalDetectionOptions{});
  return measure_axis(cloud, axis, scores, below);
}

PointCloud ball() {
  const std::array parts{Ellipsoid{{0.0, 0.0, 0.1}, {0.05, 0.05, 0.05}}};
  return testing::as_cloud(make_mirrored_body(parts, 0.001, 0.005));
}

TEST(AxisMeasures, OfAVaseAndItsAxis) {
  const AxisMeasures measures = measure(testing::vase(), {});
  EXPECT_LT(measures.symmetry, 0.01);
  EXPECT_LT(measures.residual, 0.001);  // its sides lean, within a ring too
  EXPECT_NEAR(measures.height, 0.2, 0.003);
  EXPECT_NEAR(measures.radius, 0.07, 0.003);
  EXPECT_LT(measures.off_centre, 0.02);
  EXPECT_NEAR(measures.coverage, 1.0, 0.05);
  EXPECT_NEAR(measures.upright, 1.0, 1e-9);
  EXPECT_GT(measures.along, 0.03);  // its bottom and its top
}

TEST(AxisMeasures, OfAnAxisBesideTheVase) {
  const AxisMeasures beside = measure(testing::vase(), {{0.02, 0.0, 0.0}, {0.0, 0.0, 1.0}});
  EXPECT_GT(beside.residual, 0.008);
  EXPECT_GT(beside.off_centre, 0.15);
  EXPECT_EQ(measure(testing::vase(), {}, std::nullopt).upright, -1.0);
}

TEST(AxisMeasures, OfABall) {
  const AxisMeasures measures = measure(ball(), {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  EXPECT_LT(measures.roundness, 0.01);
  EXPECT_NEAR(measures.upright, 0.0, 1e-9);
  EXPECT_GT(measure(testing::vase(), {}).roundness, 0.05);
}

TEST(AxisMeasures, OfPointsOffASphere) {
  Points one(1, 3);
  one << 1.0F, 2.0F, 3.0F;
  EXPECT_EQ(distance_off_sphere(one), 1.0);
  Points flat = ball().positions;
  flat.col(2).setConstant(0.3F);
  EXPECT_GT(distance_off_sphere(flat), 0.1);
  EXPECT_EQ(distance_off_sphere(Points(0, 3)), 1.0);
  EXPECT_LT(distance_off_sphere(ball().positions), 0.01);
}

TEST(AxisScore, IsAProbabilityWhateverIsMeasured) {
  for (const double value : {-1e300, 0.0, 0.5, 1e300, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    AxisMeasures measures;
    AxisMeasures::visit_fields(measures, [&](const char*, double& field) { field = value; });
    EXPECT_GT(axis_probability(measures), 0.0);
    EXPECT_LT(axis_probability(measures), 1.0);
  }
}

TEST(AxisScore, OfABodyOfRevolutionIsHigh) {
  EXPECT_GT(axis_probability(measure(testing::vase(), {})), 0.8);
}

}  // namespace
}  // namespace symscene
