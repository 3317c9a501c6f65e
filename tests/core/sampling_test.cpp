#include <gtest/gtest.h>

#include "core/surface_sampling.hpp"
#include "core/voxel_sampling.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

/// Two points of one voxel with these normals.
PointCloud pair_with_normals(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  PointCloud cloud;
  cloud.positions.resize(2, 3);
  cloud.positions << 0.001F, 0.001F, 0.001F, 0.003F, 0.001F, 0.001F;
  cloud.normals.resize(2, 3);
  cloud.normals << a.transpose(), b.transpose();
  return cloud;
}

TEST(VoxelDownsample, GivesTheMeanPointAndUnitNormalOfAVoxel) {
  const PointCloud sampled =
      voxel_downsample(pair_with_normals(Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitY()), 0.01);
  ASSERT_EQ(sampled.size(), 1U);
  EXPECT_TRUE(sampled.position(0).isApprox(Eigen::Vector3f(0.002F, 0.001F, 0.001F)));
  const float diagonal = std::sqrt(0.5F);
  EXPECT_TRUE(sampled.normal(0).isApprox(Eigen::Vector3f(diagonal, diagonal, 0.0F)));
}

TEST(VoxelDownsample, OfOpposingNormalsGivesNone) {
  const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f down = Eigen::Vector3f(0.01F, 0.0F, -1.0F).normalized();
  for (const Eigen::Vector3f& other : {Eigen::Vector3f(-up), down}) {
    const PointCloud sampled = voxel_downsample(pair_with_normals(up, other), 0.01);
    ASSERT_EQ(sampled.size(), 1U);
    EXPECT_EQ(sampled.normal(0), Eigen::Vector3f::Zero()) << sampled.normal(0).transpose();
  }
}

/// A square of 1 m² in the plane z = 0 and one of 3 m² in the plane x = 5, each of two triangles.
TriangleMesh two_squares() {
  const float edge = std::sqrt(3.0F);
  TriangleMesh mesh;
  mesh.vertices.resize(8, 3);
  mesh.vertices << 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 1.0F, 1.0F, 0.0F, 0.0F, 1.0F, 0.0F,  //
      5.0F, 0.0F, 0.0F, 5.0F, edge, 0.0F, 5.0F, edge, edge, 5.0F, 0.0F, edge;
  mesh.triangles.resize(4, 3);
  mesh.triangles << 0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7;
  return mesh;
}

TEST(SampleSurface, DistributesTheRequestedNumberOfPointsByArea) {
  for (const std::size_t count : {1000U, 20000U}) {
    const PointCloud cloud = sample_surface(two_squares(), count);
    const auto asked = static_cast<double>(count);
    EXPECT_NEAR(static_cast<double>(cloud.size()), asked, 0.01 * asked);
    const auto on_small = (cloud.positions.col(0).array() < 2.0F).count();
    EXPECT_NEAR(static_cast<double>(on_small), 0.25 * asked, 0.01 * asked);
  }
}

TEST(SampleSurface, CoversTheSurfaceAndHasItsNormals) {
  const PointCloud cloud = sample_surface(two_squares(), 4000);
  Eigen::Matrix4i hits = Eigen::Matrix4i::Zero();
  for (Index i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f p = cloud.position(i);
    if (p.x() > 2.0F) {
      EXPECT_FLOAT_EQ(p.x(), 5.0F);
      EXPECT_EQ(cloud.normal(i), Eigen::Vector3f::UnitX());
      continue;
    }
    EXPECT_EQ(p.z(), 0.0F);
    EXPECT_EQ(cloud.normal(i), Eigen::Vector3f::UnitZ());
    ++hits(std::min(static_cast<int>(4.0F * p.x()), 3),
           std::min(static_cast<int>(4.0F * p.y()), 3));
  }
  // 1000 points on 16 cells of the small square.
  EXPECT_GE(hits.minCoeff(), 45);
  EXPECT_LE(hits.maxCoeff(), 80);
}

TEST(SampleSurface, RefusesAMeshWithoutArea) {
  TriangleMesh mesh = two_squares();
  mesh.vertices.setZero();
  EXPECT_THROW(sample_surface(mesh, 100), InputError);
  EXPECT_THROW(sample_surface(TriangleMesh{}, 100), InputError);
}

}  // namespace
}  // namespace symscene
