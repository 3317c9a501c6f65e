#include "robots/solid_mesh.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "symscene/core/solid.hpp"

namespace symscene {
namespace {

/// Closed and seen from outside counter-clockwise, or the volume would differ.
TEST(SolidMesh, ABoxHasItsVolume) {
  const Eigen::AlignedBox3d box(Eigen::Vector3d(0.1, -0.2, 0.3), Eigen::Vector3d(0.2, 0.1, 0.7));
  const TriangleMesh mesh = box_mesh(box);
  EXPECT_NEAR(solid_properties(mesh).volume, 0.1 * 0.3 * 0.4, 1e-6);
}

TEST(SolidMesh, ACapsuleIsInscribedInItsSurface) {
  const std::vector<Capsule> capsules{{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.3}, 0.05},
                                      {{0.1, 0.2, 0.3}, {-0.1, 0.1, 0.3}, 0.07},
                                      {{0.1, 0.0, 0.5}, {0.1, 0.0, 0.2}, 0.02},  // opposite to z
                                      {{0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}, 0.1}};  // a sphere
  for (const Capsule& capsule : capsules) {
    const TriangleMesh mesh = capsule_mesh(capsule);
    const Eigen::Vector3d way = capsule.end - capsule.begin;
    for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
      const Eigen::Vector3d from = mesh.vertices.row(i).transpose().cast<double>() - capsule.begin;
      const double length = std::max(way.squaredNorm(), 1e-12);
      const double along = std::clamp(from.dot(way) / length, 0.0, 1.0);
      EXPECT_NEAR((from - along * way).norm(), capsule.radius, 1e-6);
    }
    const double r = capsule.radius;
    const double volume = std::numbers::pi * r * r * (way.norm() + 4.0 / 3.0 * r);
    const double meshed = solid_properties(mesh).volume;
    EXPECT_LT(meshed, volume);
    EXPECT_GT(meshed, 0.9 * volume);
  }
}

}  // namespace
}  // namespace symscene
