#include "core/nearest_orthogonal.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace {

Eigen::Matrix3d random_rotation() { return Eigen::Quaterniond::UnitRandom().toRotationMatrix(); }

TEST(NearestOrthogonal, OfAStretchedOrthogonalMatrixIsThatMatrix) {
  const Eigen::Matrix3d stretch = Eigen::Vector3d(0.5, 1.0, 2.0).asDiagonal();
  const Eigen::Matrix3d mirror = Eigen::Vector3d(1.0, 1.0, -1.0).asDiagonal();
  for (int i = 0; i < 50; ++i) {
    const Eigen::Matrix3d turn = random_rotation(), axes = random_rotation();
    const Eigen::Matrix3d stretched = axes * stretch * axes.transpose();
    EXPECT_LT((symscene::nearest_orthogonal(turn * stretched) - turn).norm(), 1e-12);
    EXPECT_LT((symscene::nearest_orthogonal(turn * mirror * stretched) - turn * mirror).norm(),
              1e-12);
  }
}

TEST(NearestRotation, IsProperAndNoRotationIsNearer) {
  for (int i = 0; i < 50; ++i) {
    const Eigen::Matrix3d matrix = Eigen::Matrix3d::Random();
    const Eigen::Matrix3d nearest = symscene::nearest_rotation(matrix);
    EXPECT_LT((nearest.transpose() * nearest - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(nearest.determinant(), 1.0, 1e-12);
    for (int k = 0; k < 20; ++k)
      EXPECT_LE((matrix - nearest).norm(), (matrix - random_rotation()).norm() + 1e-12);
  }
}

}  // namespace
