#include "symmetry/axis_fit.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace symscene {
namespace {

using testing::moved;
using testing::random_direction;
using testing::random_motion;

RotationAxis axis_after(const Eigen::Isometry3d& motion) {
  return {motion.translation(), motion.linear() * Eigen::Vector3d::UnitZ()};
}

AxisFit best_fit(const PointCloud& cloud) {
  AxisFit best;
  best.cost = 2.0;
  for (const RotationAxis& initial : initial_axes(cloud, {})) {
    const AxisFit fit = fit_axis(cloud, initial);
    if (fit.cost < best.cost) best = fit;
  }
  return best;
}

void expect_near(const RotationAxis& found, const RotationAxis& truth, const Eigen::Vector3d& at,
                 double angle, double distance) {
  const SymmetryDifference apart = difference(found, truth, at);
  EXPECT_LT(apart.angle, angle);
  EXPECT_LT(apart.distance, distance);
}

TEST(AxisFit, FindsTheAxisOfAWholeSurfaceWhereverItLies) {
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const Eigen::Isometry3d motion = random_motion(generator);
    const PointCloud cloud = moved(testing::vase(), motion);
    expect_near(best_fit(cloud).axis, axis_after(motion), centroid(cloud.positions), radians(0.5),
                0.001);
  }
}

TEST(AxisFit, FindsTheAxisFromOneSide) {
  const PointCloud seen = testing::seen_from(testing::vase(), {1.0F, 0.3F, 0.6F});
  const AxisFit fit = best_fit(seen);
  expect_near(fit.axis, {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()},
              centroid(seen.positions), radians(1.0), 0.002);
}

TEST(AxisFit, IgnoresAQuarterOfOutliers) {
  PointCloud cloud = testing::vase();
  std::mt19937 generator(3);
  for (Index i = 0; i < cloud.size(); i += 4) {
    cloud.normals.row(i) = random_direction(generator).cast<float>().transpose();
  }
  expect_near(best_fit(cloud).axis, {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()},
              centroid(cloud.positions), radians(2.0), 0.003);
}

TEST(AxisFit, ConvergesFromTwentyDegreesAndTwoCentimetres) {
  const PointCloud cloud = testing::vase();
  const RotationAxis truth;
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const Eigen::Vector3d turn_about =
        random_direction(generator).cross(truth.direction).normalized();
    const RotationAxis initial{0.02 * turn_about,
                               Eigen::AngleAxisd(radians(20.0), turn_about) * truth.direction};
    const AxisFit fit = fit_axis(cloud, initial);
    EXPECT_EQ(fit.status, FitStatus::converged);
    expect_near(fit.axis, truth, centroid(cloud.positions), radians(0.5), 0.001);
  }
}

TEST(AxisFit, ReportsTooFewPoints) {
  const PointCloud cloud = select(testing::vase(), PointIndices{0, 1, 2});
  EXPECT_EQ(fit_axis(cloud, {}).status, FitStatus::too_few_points);
  EXPECT_TRUE(initial_axes(cloud, {}).empty());
}

TEST(AxisFit, OfAFlatPatchIsFinite) {
  const PointCloud patch = testing::seen_from(testing::box({0.1, 0.1, 0.1}), {0.0F, 0.0F, 0.11F});
  const std::vector<RotationAxis> initials = initial_axes(patch, {Eigen::Vector3d::UnitZ()});
  ASSERT_FALSE(initials.empty());
  for (const RotationAxis& initial : initials) {
    const AxisFit fit = fit_axis(patch, initial);
    EXPECT_TRUE(fit.axis.point.allFinite() && fit.axis.direction.allFinite());
  }
}

}  // namespace
}  // namespace symscene
