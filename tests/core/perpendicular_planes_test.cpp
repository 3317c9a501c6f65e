#include "core/perpendicular_planes.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace symscene {
namespace {

ObjectPlane upright_plane(double angle) {
  return {{Eigen::Vector3d::Zero(), {std::cos(angle), std::sin(angle), 0.0}}, 0.0};
}

TEST(PerpendicularPlanes, AreThoseAtRightAnglesToTheFirst) {
  const std::vector<ObjectPlane> planes{upright_plane(0.0), upright_plane(0.5),
                                        upright_plane(std::numbers::pi / 2)};
  const std::vector<ReflectionPlane> chosen = perpendicular_planes(planes, 0.1);
  ASSERT_EQ(chosen.size(), 2U);
  EXPECT_EQ(chosen[0].normal, planes[0].plane.normal);
  EXPECT_EQ(chosen[1].normal, planes[2].plane.normal);
}

TEST(PerpendicularPlanes, AreAtMostThreeForAnyTolerance) {
  std::vector<ObjectPlane> planes;
  for (int k = 0; k < 40; ++k) planes.push_back(upright_plane(0.07 * k));
  EXPECT_EQ(perpendicular_planes(planes, std::numbers::pi / 2).size(), 3U);
}

}  // namespace
}  // namespace symscene
