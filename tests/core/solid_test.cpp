#include "symscene/core/solid.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include <Eigen/Geometry>

namespace symscene {
namespace {

/// A box about a centre: its eight corners and twelve triangles.
TriangleMesh box_mesh(const Eigen::Vector3d& size, const Eigen::Isometry3d& T_world_box) {
  TriangleMesh mesh;
  mesh.vertices.resize(8, 3);
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d corner((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2) - 0.5);
    mesh.vertices.row(k) =
        (T_world_box * corner.cwiseProduct(size).eval()).cast<float>().transpose();
  }
  mesh.triangles.resize(12, 3);
  mesh.triangles << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2,
      2, 4, 6, 1, 3, 5, 3, 7, 5;
  return mesh;
}

TEST(SolidProperties, OfABoxAreThoseOfItsFormulas) {
  const Eigen::Vector3d size(0.3, 0.1, 0.2);
  Eigen::Isometry3d T_world_box = Eigen::Isometry3d::Identity();
  T_world_box.translate(Eigen::Vector3d(1.5, -2.0, 0.7));
  T_world_box.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  const SolidProperties solid = solid_properties(box_mesh(size, T_world_box));
  EXPECT_NEAR(solid.volume, size.prod(), 1e-7);
  EXPECT_LT((solid.centre_of_mass - T_world_box.translation()).norm(), 1e-6);
  // (b² + c²) / 12 about the longest edge first.
  EXPECT_NEAR(solid.principal_moments[0], (0.01 + 0.04) / 12.0, 1e-7);
  EXPECT_NEAR(solid.principal_moments[1], (0.01 + 0.09) / 12.0, 1e-7);
  EXPECT_NEAR(solid.principal_moments[2], (0.04 + 0.09) / 12.0, 1e-7);
  const Eigen::Matrix3d axes = T_world_box.linear().transpose() * solid.principal_axes;
  EXPECT_GT(std::abs(axes(0, 0)), 1.0 - 1e-6);
  EXPECT_GT(std::abs(axes(2, 1)), 1.0 - 1e-6);
  EXPECT_GT(std::abs(axes(1, 2)), 1.0 - 1e-6);
  EXPECT_NEAR(solid.principal_axes.determinant(), 1.0, 1e-9);
}

TEST(SolidProperties, OfTwoBodiesAreThoseOfTheirSum) {
  const TriangleMesh a = box_mesh({0.1, 0.1, 0.1}, Eigen::Isometry3d::Identity());
  const TriangleMesh b =
      box_mesh({0.1, 0.2, 0.1}, Eigen::Isometry3d(Eigen::Translation3d(0.3, 0.0, 0.0)));
  TriangleMesh both;
  both.vertices.resize(16, 3);
  both.vertices << a.vertices, b.vertices;
  both.triangles.resize(24, 3);
  both.triangles << a.triangles, (b.triangles.array() + 8U).matrix();
  const SolidProperties solid = solid_properties(both);
  EXPECT_NEAR(solid.volume, 0.003, 1e-8);
  EXPECT_NEAR(solid.centre_of_mass.x(), 0.2, 1e-6);
}

TEST(SolidProperties, OfNothingAndOfAnOpenSheetAreZero) {
  EXPECT_EQ(solid_properties({}).volume, 0.0);
  TriangleMesh sheet;
  sheet.vertices.resize(3, 3);
  sheet.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0;
  sheet.triangles.resize(1, 3);
  sheet.triangles << 0, 1, 2;
  const SolidProperties solid = solid_properties(sheet);
  EXPECT_EQ(solid.volume, 0.0);
  EXPECT_TRUE(solid.principal_axes.isIdentity());
  EXPECT_TRUE(solid.centre_of_mass.isZero());
}

}  // namespace
}  // namespace symscene
