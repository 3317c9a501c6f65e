#include "symmetry/finite_group.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include <Eigen/Geometry>

namespace symscene {
namespace {

Eigen::Matrix3d turn(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(degrees / 180.0 * std::numbers::pi, axis.normalized())
      .toRotationMatrix();
}

TEST(FiniteGroup, OfATurnIsCyclic) {
  const FiniteGroup group = FiniteGroup().with(turn(60, Eigen::Vector3d::UnitX()), 100);
  EXPECT_EQ(group.elements().size(), 6U);
  EXPECT_TRUE(group.holds(turn(-60, Eigen::Vector3d::UnitX())));
  EXPECT_FALSE(group.holds(turn(90, Eigen::Vector3d::UnitX())));
}

TEST(FiniteGroup, OfTheTurnsOfACubeHas24ElementsAnd48WithAReflection) {
  FiniteGroup group;
  group = group.with(turn(90, Eigen::Vector3d::UnitZ()), 200);
  group = group.with(turn(90, Eigen::Vector3d::UnitX()), 200);
  EXPECT_EQ(group.elements().size(), 24U);
  EXPECT_EQ(group.with(Eigen::Vector3d(1, 1, -1).asDiagonal(), 200).elements().size(), 48U);
}

TEST(FiniteGroup, OfInexactTurnsBecomesExact) {
  FiniteGroup group;
  group = group.with(turn(180.5, Eigen::Vector3d(0.0, 0.01, 1.0)), 100);
  group = group.with(turn(179.8, Eigen::Vector3d(1.0, 0.02, 0.01)), 100);
  ASSERT_EQ(group.elements().size(), 4U);
  const FiniteGroup exact = group.exact();
  for (const Eigen::Matrix3d& a : exact.elements()) {
    EXPECT_NEAR((a * a.transpose() - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-12);
    double nearest = 1.0;
    for (const Eigen::Matrix3d& b : exact.elements())
      nearest = std::min(nearest, (a * exact.elements()[1] - b).norm());
    EXPECT_LT(nearest, 1e-12);
  }
}

TEST(FiniteGroup, StopsWhereItHasTooManyElements) {
  EXPECT_GT(FiniteGroup().with(turn(17, Eigen::Vector3d::UnitX()), 10).elements().size(), 10U);
}

}  // namespace
}  // namespace symscene
