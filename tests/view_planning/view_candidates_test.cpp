#include "symscene/view_planning/view_candidates.hpp"

#include <gtest/gtest.h>

#include "symscene/core/error.hpp"

namespace symscene {
namespace {

const Eigen::Vector3d target(0.1, -0.2, 0.3);
const Eigen::Vector3d up = Eigen::Vector3d(0.1, 0.2, 1.0).normalized();

TEST(ViewsOnSphere, LookAtTheTargetFromItsDistanceUpright) {
  const auto views = views_on_sphere(target, up, 0.6);
  EXPECT_EQ(views.size(), 34U);
  for (const Eigen::Isometry3d& T : views) {
    EXPECT_TRUE((T * Eigen::Vector3d(0.0, 0.0, 0.6)).isApprox(target, 1e-12));
    EXPECT_NEAR(T.linear().determinant(), 1.0, 1e-12);
    EXPECT_NEAR(T.linear().col(0).dot(up), 0.0, 1e-12) << "the horizon is level";
    EXPECT_LT(T.linear().col(1).dot(up), 0.0) << "y of a camera points down";
  }
}

TEST(ViewsOnSphere, KeepTheAngleOfTheirRing) {
  const std::array<ViewRing, 1> ring{{{radians(40.0), 5}}};
  for (const Eigen::Isometry3d& T : views_on_sphere(target, up, 0.5, ring, 0.3))
    EXPECT_NEAR((T.translation() - target).normalized().dot(up), std::cos(radians(40.0)), 1e-12);
}

TEST(ViewsOnSphere, RefuseARadiusOfZeroAndRingsWithoutViews) {
  EXPECT_THROW(views_on_sphere(target, up, 0.0), InputError);
  const std::array<ViewRing, 1> none{{{0.5, 0}}};
  EXPECT_THROW(views_on_sphere(target, up, 0.5, none), InputError);
}

}  // namespace
}  // namespace symscene
