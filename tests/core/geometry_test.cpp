#include "symscene/core/geometry.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/random_clouds.hpp"
#include "symscene/core/types.hpp"

namespace symscene {
namespace {

using testing::random_direction;
using testing::random_motion;
using testing::random_vector;
using testing::seeds;

ReflectionPlane random_plane(std::mt19937& generator) {
  const Eigen::Vector3d point = random_vector(generator);
  return {point, random_direction(generator)};
}

RotationAxis random_axis(std::mt19937& generator) {
  const Eigen::Vector3d point = random_vector(generator);
  return {point, random_direction(generator)};
}

ReflectionPlane moved(const Eigen::Isometry3d& motion, const ReflectionPlane& plane) {
  return {motion * plane.point, motion.linear() * plane.normal};
}

RotationAxis moved(const Eigen::Isometry3d& motion, const RotationAxis& axis) {
  return {motion * axis.point, motion.linear() * axis.direction};
}

constexpr double tolerance = 1e-12;

TEST(ReflectionPlane, ReflectingTwiceIsTheIdentity) {
  for (const std::uint32_t seed : seeds) {
    std::mt19937 generator(seed);
    const ReflectionPlane plane = random_plane(generator);
    const Eigen::Vector3d p = random_vector(generator);
    const Eigen::Vector3d d = random_direction(generator);
    EXPECT_LT((plane.reflect_point(plane.reflect_point(p)) - p).norm(), tolerance);
    EXPECT_LT((plane.reflect_direction(plane.reflect_direction(d)) - d).norm(), tolerance);
  }
}

TEST(ReflectionPlane, TheMidpointOfAPointAndItsImageIsItsProjection) {
  for (const std::uint32_t seed : seeds) {
    std::mt19937 generator(seed);
    const ReflectionPlane plane = random_plane(generator);
    const Eigen::Vector3d p = random_vector(generator);
    const Eigen::Vector3d midpoint = 0.5 * (p + plane.reflect_point(p));
    EXPECT_LT((midpoint - plane.project(p)).norm(), tolerance);
    EXPECT_NEAR(plane.signed_distance(midpoint), 0.0, tolerance);
  }
}

TEST(ReflectionPlane, DoesNotDependOnTheSignOfItsNormal) {
  std::mt19937 generator(11);
  const ReflectionPlane plane = random_plane(generator);
  const ReflectionPlane flipped{plane.point, -plane.normal};
  const Eigen::Vector3d p = random_vector(generator);
  EXPECT_LT((plane.reflect_point(p) - flipped.reflect_point(p)).norm(), tolerance);
  EXPECT_NEAR(difference(plane, flipped, p).angle, 0.0, tolerance);
  EXPECT_NEAR(difference(plane, flipped, p).distance, 0.0, tolerance);
}

TEST(RotationAxis, RotatingThereAndBackIsTheIdentity) {
  for (const std::uint32_t seed : seeds) {
    std::mt19937 generator(seed);
    const RotationAxis axis = random_axis(generator);
    const Eigen::Vector3d p = random_vector(generator);
    for (const double angle : {0.1, 1.0, 3.0, -2.0}) {
      EXPECT_LT((axis.rotate_point(axis.rotate_point(p, angle), -angle) - p).norm(), tolerance);
    }
  }
}

TEST(RotationAxis, RotatingKeepsDistanceAndProjection) {
  for (const std::uint32_t seed : seeds) {
    std::mt19937 generator(seed);
    const RotationAxis axis = random_axis(generator);
    const Eigen::Vector3d p = random_vector(generator);
    const Eigen::Vector3d image = axis.rotate_point(p, 2.1);
    EXPECT_NEAR(axis.distance(p), axis.distance(image), tolerance);
    EXPECT_LT((axis.project(p) - axis.project(image)).norm(), tolerance);
    EXPECT_NEAR(axis.distance(axis.project(p)), 0.0, tolerance);
  }
}

TEST(RotationAxis, PositiveAnglesTurnCounterClockwise) {
  const RotationAxis axis{{1.0, 0.0, 0.0}, Eigen::Vector3d::UnitZ()};
  const Eigen::Vector3d quarter = axis.rotate_point({2.0, 0.0, 5.0}, radians(90.0));
  EXPECT_LT((quarter - Eigen::Vector3d(1.0, 1.0, 5.0)).norm(), tolerance);
}

template <class Symmetry>
void expect_a_metric(const Symmetry& a, const Symmetry& b, std::mt19937& generator) {
  const Eigen::Vector3d reference = random_vector(generator);
  const Eigen::Isometry3d motion = random_motion(generator);
  const SymmetryDifference ab = difference(a, b, reference);
  const SymmetryDifference ba = difference(b, a, reference);
  const SymmetryDifference elsewhere =
      difference(moved(motion, a), moved(motion, b), motion * reference);
  EXPECT_NEAR(difference(a, a, reference).angle, 0.0, tolerance);
  EXPECT_NEAR(difference(a, a, reference).distance, 0.0, tolerance);
  EXPECT_NEAR(ab.angle, ba.angle, tolerance);
  EXPECT_NEAR(ab.distance, ba.distance, tolerance);
  EXPECT_NEAR(ab.angle, elsewhere.angle, 1e-9);
  EXPECT_NEAR(ab.distance, elsewhere.distance, 1e-9);
  EXPECT_LE(ab.angle, std::numbers::pi / 2);
}

TEST(SymmetryDifference, IsSymmetricAndInvariantUnderRigidMotion) {
  for (const std::uint32_t seed : seeds) {
    std::mt19937 generator(seed);
    expect_a_metric(random_axis(generator), random_axis(generator), generator);
    expect_a_metric(random_plane(generator), random_plane(generator), generator);
  }
}

TEST(SymmetryDifference, MeasuresParallelPlanesByTheirGap) {
  const ReflectionPlane a{{0.0, 3.0, 0.0}, Eigen::Vector3d::UnitX()};
  const ReflectionPlane b{{0.2, -7.0, 1.0}, -Eigen::Vector3d::UnitX()};
  const SymmetryDifference apart = difference(a, b, {5.0, 5.0, 5.0});
  EXPECT_NEAR(apart.angle, 0.0, tolerance);
  EXPECT_NEAR(apart.distance, 0.2, tolerance);
}

TEST(Angle, IsExactForTinyAnglesAndForOpposites) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX();
  EXPECT_NEAR(angle_between(x, {1.0, 1e-9, 0.0}), 1e-9, 1e-18);
  EXPECT_NEAR(angle_between(x, -3.0 * x), std::numbers::pi, tolerance);
  EXPECT_NEAR(line_angle(x, -3.0 * x), 0.0, tolerance);
  EXPECT_NEAR(line_angle(x, Eigen::Vector3d::UnitY()), std::numbers::pi / 2, tolerance);
  EXPECT_EQ(angle_between(x, Eigen::Vector3d::Zero()), 0.0);
}

TEST(ShortestRotation, TurnsOneDirectionIntoTheOtherByTheAngleBetweenThem) {
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d from = Eigen::Vector3d::Random(), to = Eigen::Vector3d::Random();
    const Eigen::Matrix3d turn = symscene::shortest_rotation(from, to);
    EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-12);
    EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), symscene::angle_between(from, to), 1e-7);
  }
}

TEST(ShortestRotation, OfOppositeDirectionsIsAHalfTurn) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Matrix3d turn = symscene::shortest_rotation(up, -up);
  EXPECT_LT((turn * up + up).norm(), 1e-12);
  EXPECT_NEAR(turn.determinant(), 1.0, 1e-12);
}

TEST(Ramp, MapsTheBoundsToZeroAndOneAndClampsOutside) {
  EXPECT_EQ(ramp(10.0, 10.0, 60.0), 0.0);
  EXPECT_EQ(ramp(60.0, 10.0, 60.0), 1.0);
  EXPECT_EQ(ramp(35.0, 10.0, 60.0), 0.5);
  EXPECT_EQ(ramp(-1.0, 10.0, 60.0), 0.0);
  EXPECT_EQ(ramp(1e9, 10.0, 60.0), 1.0);
  EXPECT_EQ(ramp(4.0, 5.0, 5.0), 0.0);
  EXPECT_EQ(ramp(6.0, 5.0, 5.0), 1.0);
}

}  // namespace
}  // namespace symscene
