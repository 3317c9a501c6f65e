#include "symscene/core/normal_estimation.hpp"

#include <gtest/gtest.h>

#include "core/random_clouds.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Evenly distributed points on the unit sphere, along a spiral from pole to pole.
Points sphere(Eigen::Index count) {
  const double golden_angle = radians(180.0) * (3.0 - std::sqrt(5.0));
  Points points(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
    const double angle = golden_angle * static_cast<double>(i);
    const double radius = std::sqrt(1.0 - z * z);
    points.row(i) =
        Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), z).cast<float>();
  }
  return points;
}

double away_from_origin(const Eigen::Vector3f& position, const Eigen::Vector3f& direction) {
  return double{position.dot(direction)};
}

TEST(EstimateNormals, OfASpherePointAwayFromItsCentre) {
  const Points points = sphere(2000);
  const Points normals = estimate_normals(points, away_from_origin);
  ASSERT_EQ(normals.rows(), points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    EXPECT_GT(normals.row(i).dot(points.row(i)), std::cos(radians(3.0))) << i;
}

TEST(EstimateNormals, AgreeInOrientationEvenIfOnlyAFewPointsVote) {
  const Points points = sphere(2000);
  const auto votes_at_the_top = [](const Eigen::Vector3f& position,
                                   const Eigen::Vector3f& direction) {
    return position.z() > 0.95F ? double{-direction.z()} : 0.0;
  };
  const Points normals = estimate_normals(points, votes_at_the_top);
  EXPECT_LT((normals.array() * points.array()).rowwise().sum().maxCoeff(), -std::cos(radians(3.0)));
}

TEST(EstimateNormals, OfATiltedPlaneAreItsNormal) {
  std::mt19937 generator(3);
  const Eigen::Matrix3d turn = testing::random_motion(generator).linear();
  Points points = testing::random_points(4, 500);
  points.col(2).setZero();
  points = (points.cast<double>() * turn.transpose()).cast<float>().eval();
  const Eigen::Vector3f up = turn.col(2).cast<float>();
  const Points normals =
      estimate_normals(points, [&](const Eigen::Vector3f&, const Eigen::Vector3f& direction) {
        return double{direction.dot(up)};
      });
  EXPECT_GT((normals * up).minCoeff(), 1.0F - 1e-5F);
}

TEST(EstimateNormals, OfPointsOnALineAreZero) {
  Points line = Points::Zero(50, 3);
  for (Eigen::Index i = 0; i < line.rows(); ++i) line(i, 1) = 0.01F * static_cast<float>(i);
  EXPECT_TRUE(estimate_normals(line, away_from_origin).isZero(0.0F));
}

TEST(EstimateNormals, RefusesPointsThatAreNotFinite) {
  Points points = testing::random_points(1, 20);
  points(7, 1) = std::nanf("");
  EXPECT_THROW(estimate_normals(points, away_from_origin), InputError);
}

}  // namespace
}  // namespace symscene
