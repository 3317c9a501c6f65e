#include "io/collision_capsules.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

double distance_to_segment(const Capsule& capsule, const Eigen::Vector3d& point) {
  const Eigen::Vector3d along = capsule.end - capsule.begin;
  const double length = along.squaredNorm();
  const double t = length > 0.0 ? (point - capsule.begin).dot(along) / length : 0.0;
  return (point - capsule.begin - std::clamp(t, 0.0, 1.0) * along).norm();
}

Eigen::Isometry3d somewhere() {
  return Eigen::Translation3d(0.1, -0.2, 0.3) *
         Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -1.0).normalized());
}

TEST(CollisionCapsules, JoinACylinderWithTheSpheresAtItsEnds) {
  const Eigen::Isometry3d T = somewhere();
  const auto sphere_at = [&](double z, double radius) {
    return CollisionShape{
        CollisionKind::sphere, T * Eigen::Translation3d(0.0, 0.0, z), {radius, 0.0, 0.0}};
  };
  const CollisionShape cylinder{CollisionKind::cylinder, T, {0.05, 0.2, 0.0}};
  const auto joined = collision_capsules({sphere_at(0.1, 0.05), cylinder, sphere_at(-0.1, 0.05)});
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_TRUE(joined[0].begin.isApprox(T * Eigen::Vector3d(0.0, 0.0, -0.1), 1e-12));
  EXPECT_TRUE(joined[0].end.isApprox(T * Eigen::Vector3d(0.0, 0.0, 0.1), 1e-12));
  EXPECT_EQ(joined[0].radius, 0.05);
  // A sphere of another size or place stays.
  EXPECT_EQ(collision_capsules({cylinder, sphere_at(0.1, 0.06), sphere_at(0.3, 0.05)}).size(), 3U);
}

TEST(CollisionCapsules, ContainTheCornersOfBoxes) {
  for (const Eigen::Vector3d& size :
       {Eigen::Vector3d(0.1, 0.1, 0.1), Eigen::Vector3d(0.02, 0.5, 0.04),
        Eigen::Vector3d(0.3, 0.2, 0.01)}) {
    const auto capsules = collision_capsules({{CollisionKind::box, somewhere(), size}});
    ASSERT_EQ(capsules.size(), 1U);
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d signs((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                                  (corner & 4) != 0 ? 0.5 : -0.5);
      const Eigen::Vector3d point = somewhere() * signs.cwiseProduct(size);
      EXPECT_LE(distance_to_segment(capsules[0], point), capsules[0].radius + 1e-12);
    }
  }
}

}  // namespace
}  // namespace symscene
