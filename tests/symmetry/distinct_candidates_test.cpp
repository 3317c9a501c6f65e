#include "symmetry/distinct_candidates.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

constexpr EqualPlanes equal{radians(7.0), 0.01, 0.3};

/// Two groups of points, 1 m apart.
PointCloud two_groups() {
  PointCloud cloud;
  cloud.positions.resize(4, 3);
  cloud.positions << 0.0F, 0.1F, 0.0F, 0.0F, -0.1F, 0.0F, 0.0F, 1.1F, 0.0F, 0.0F, 0.9F, 0.0F;
  return cloud;
}

/// A plane across x, `offset` from the origin, that a group supports.
ReflectionalCandidate across_x(double offset, const PointIndices& support) {
  return {{{offset, 0.0, 0.0}, Eigen::Vector3d::UnitX()}, {}, support};
}

TEST(DistinctCandidates, KeepTheFirstOfEqualPlanes) {
  const PointCloud cloud = two_groups();
  const std::vector<ReflectionalCandidate> kept = distinct_candidates(
      {across_x(0.0, {0, 1}), across_x(0.005, {0, 1}), across_x(0.02, {0, 1})}, cloud, equal);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].plane.point.x(), 0.0);
  EXPECT_EQ(kept[1].plane.point.x(), 0.02);
}

TEST(DistinctCandidates, AreTwoWhereTheirSupportsAreFarApart) {
  const PointCloud cloud = two_groups();
  EXPECT_EQ(
      distinct_candidates({across_x(0.0, {0, 1}), across_x(0.0, {2, 3})}, cloud, equal).size(), 2U);
}

TEST(WithoutKnown, LeavesOutWhatRepeatsAKnownPlaneAndNothingElse) {
  const PointCloud cloud = two_groups();
  const std::vector<ReflectionalCandidate> known{across_x(0.0, {0, 1})};
  const std::vector<ReflectionalCandidate> further =
      without_known({across_x(0.005, {0, 1}), across_x(0.05, {0, 1}), across_x(0.0, {2, 3})}, known,
                    cloud, equal);
  ASSERT_EQ(further.size(), 2U);
  EXPECT_EQ(further[0].plane.point.x(), 0.05);
  EXPECT_EQ(further[1].support, PointIndices({2, 3}));
  EXPECT_EQ(without_known({}, known, cloud, equal).size(), 0U);
  EXPECT_EQ(without_known(known, {}, cloud, equal).size(), 1U);
}

}  // namespace
}  // namespace symscene
