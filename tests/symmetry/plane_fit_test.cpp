#include "symmetry/plane_fit.hpp"

#include <set>

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace symscene {
namespace {

using testing::all_of;
using testing::moved;

PlaneFit fitted(const PointCloud& cloud, const ReflectionPlane& initial) {
  const CellList cells(cloud.positions, 0.01F);
  return fit_plane({cloud, cells}, all_of(cloud), initial);
}

TEST(PlaneFit, RecoversEachPlaneOfABoxWhereverItLies) {
  const PointCloud box = testing::box({0.12, 0.18, 0.08});
  const Eigen::Vector3d centre(0.0, 0.0, 0.04);
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const Eigen::Isometry3d motion = testing::random_motion(generator);
    const PointCloud cloud = moved(box, motion);
    for (int axis = 0; axis < 3; ++axis) {
      const ReflectionPlane truth{motion * centre, motion.linear() * Eigen::Vector3d::Unit(axis)};
      const Eigen::Vector3d tilt =
          Eigen::AngleAxisd(radians(8.0), testing::random_direction(generator)) * truth.normal;
      const PlaneFit fit = fitted(cloud, {truth.point + 0.004 * truth.normal, tilt});
      EXPECT_EQ(fit.status, FitStatus::converged);
      const SymmetryDifference apart = difference(fit.plane, truth, motion * centre);
      EXPECT_LT(apart.angle, radians(1.0));
      EXPECT_LT(apart.distance, 0.001);
    }
  }
}

TEST(PlaneFit, ReportsWhenNothingMatches) {
  const PointCloud cloud = testing::box({0.1, 0.1, 0.1});
  const ReflectionPlane far_off{{1.0, 0.0, 0.0}, Eigen::Vector3d::UnitX()};
  EXPECT_EQ(fitted(cloud, far_off).status, FitStatus::too_few_points);
}

TEST(Correspondences, OfASymmetricCloudPairEveryPointAwayFromThePlane) {
  const PointCloud cloud = testing::box({0.1, 0.16, 0.06});
  const CellList cells(cloud.positions, 0.01F);
  const ReflectionPlane plane{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()};
  const CorrespondenceOptions options;
  const std::vector<Correspondence> matches =
      reflect_onto({cloud, cells}, all_of(cloud), plane, options);
  std::size_t away = 0;
  for (Index i = 0; i < cloud.size(); ++i) away += std::abs(cloud.positions(i, 0)) >= 0.01F ? 1 : 0;
  EXPECT_GT(static_cast<double>(matches.size()), 0.98 * static_cast<double>(away));
  for (const Correspondence& match : matches) {
    EXPECT_LE(match.squared_distance, 0.01F * 0.01F);
    EXPECT_GE(std::abs(cloud.positions(match.from, 0)), 0.01F);
  }
}

TEST(Correspondences, DoNotDependOnThePlanesThatWereMatchedBefore) {
  const PointCloud box = testing::box({0.1, 0.16, 0.06});
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const PointCloud cloud = moved(box, testing::random_motion(generator));
    const CellList cells(cloud.positions, 0.01F);
    const std::vector<Index> sources = all_of(cloud);
    const CorrespondenceOptions options;
    ReflectionMatcher matcher({cloud, cells}, sources, options);
    ReflectionPlane plane{centroid(cloud.positions), testing::random_direction(generator)};
    for (int step = 0; step < 6; ++step) {
      // Small steps, as those of a fit, then one to anywhere.
      plane.point += 0.002 * plane.normal;
      if (step == 4) plane.normal = testing::random_direction(generator);
      const std::vector<Correspondence> matches = matcher.match(plane);
      const std::vector<Correspondence> alone =
          reflect_onto({cloud, cells}, sources, plane, options);
      ASSERT_EQ(matches.size(), alone.size());
      for (std::size_t k = 0; k < matches.size(); ++k) {
        EXPECT_EQ(matches[k].from, alone[k].from);
        EXPECT_EQ(matches[k].to, alone[k].to);
        EXPECT_EQ(matches[k].squared_distance, alone[k].squared_distance);
      }
    }
  }
}

TEST(Correspondences, OneToOneUseNoMatchTwiceAndKeepTheNearest) {
  const std::vector<Correspondence> one =
      one_to_one({{0, 7, 4.0F, 0.0F}, {1, 7, 1.0F, 0.0F}, {2, 8, 9.0F, 0.0F}});
  ASSERT_EQ(one.size(), 2U);
  EXPECT_EQ(one[0].from, 1U);
  EXPECT_EQ(one[1].from, 2U);
}

TEST(Correspondences, FoldOppositeNormalsOnlyWhereTold) {
  PointCloud cloud;
  cloud.positions.resize(2, 3);
  cloud.normals.resize(2, 3);
  cloud.positions << 0.05F, 0.0F, 0.0F, -0.05F, 0.0F, 0.0F;
  cloud.normals << 1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F;  // a mirror image would face the other way
  const CellList cells(cloud.positions, 0.01F);
  const ReflectionPlane plane;
  CorrespondenceOptions options;
  EXPECT_EQ(reflect_onto({cloud, cells}, all_of(cloud), plane, options).size(), 2U);
  options.fold_thin_walls = false;
  EXPECT_TRUE(reflect_onto({cloud, cells}, all_of(cloud), plane, options).empty());
}

}  // namespace
}  // namespace symscene
