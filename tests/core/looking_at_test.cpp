#include "core/looking_at.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

const Eigen::Vector3d target(0.1, -0.2, 0.3);
const Eigen::Vector3d up = Eigen::Vector3d(0.1, 0.2, 1.0).normalized();

TEST(LookingAt, HasTheTargetOnItsAxisAndTheHorizonLevel) {
  const Eigen::Vector3d eye(0.9, 0.4, 1.1);
  const Eigen::Isometry3d T = looking_at(eye, target, up);
  EXPECT_TRUE((T * Eigen::Vector3d(0.0, 0.0, (target - eye).norm())).isApprox(target, 1e-12));
  EXPECT_NEAR(T.linear().determinant(), 1.0, 1e-12);
  EXPECT_NEAR(T.linear().col(0).dot(up), 0.0, 1e-12);
  EXPECT_LT(T.linear().col(1).dot(up), 0.0) << "y of a camera points down";
}

TEST(LookingAt, TakesAnyWayRoundStraightFromAbove) {
  const Eigen::Isometry3d T = looking_at(target + 0.5 * up, target, up);
  EXPECT_TRUE(T.linear().col(2).isApprox(-up, 1e-9));
  EXPECT_TRUE((T.linear() * T.linear().transpose()).isIdentity(1e-9));
}

}  // namespace
}  // namespace symscene
