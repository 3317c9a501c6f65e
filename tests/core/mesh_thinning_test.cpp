#include "core/mesh_thinning.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <utility>

#include "core/vertex_normals.hpp"

namespace symscene {
namespace {

/// A closed torus of radii 0.1 and 0.04 about z, coloured by height.
TriangleMesh make_torus(Index around, Index across) {
  TriangleMesh mesh;
  mesh.vertices.resize(around * across, 3);
  mesh.colors.resize(around * across, 3);
  mesh.triangles.resize(2 * around * across, 3);
  for (Index i = 0; i < around; ++i) {
    for (Index k = 0; k < across; ++k) {
      const float a = 6.2831853F * static_cast<float>(i) / static_cast<float>(around);
      const float b = 6.2831853F * static_cast<float>(k) / static_cast<float>(across);
      const float radius = 0.1F + 0.04F * std::cos(b);
      const Index here = i * across + k;
      mesh.vertices.row(here) << radius * std::cos(a), radius * std::sin(a), 0.04F * std::sin(b);
      mesh.colors.row(here).setConstant(static_cast<std::uint8_t>(127.0F + 120.0F * std::sin(b)));
      const Index right = (i + 1) % around * across + k;
      const Index up = i * across + (k + 1) % across;
      const Index both = (i + 1) % around * across + (k + 1) % across;
      mesh.triangles.row(2 * here) << here, right, both;
      mesh.triangles.row(2 * here + 1) << here, both, up;
    }
  }
  return mesh;
}

/// Number of triangles that contain the edge a → b minus those that contain b → a.
std::map<std::pair<Index, Index>, int> open_edges(const TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, int> balance;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const Index a = mesh.triangles(t, k), b = mesh.triangles(t, (k + 1) % 3);
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  std::erase_if(balance, [](const auto& edge) { return edge.second == 0; });
  return balance;
}

TEST(MeshThinning, AClosedSurfaceStaysClosed) {
  const TriangleMesh torus = make_torus(200, 80);
  ASSERT_TRUE(open_edges(torus).empty());
  for (const float cell : {0.004F, 0.009F, 0.02F}) {
    EXPECT_TRUE(open_edges(cluster_vertices(torus, cell)).empty()) << cell;
  }
}

TEST(MeshThinning, VerticesMoveByLessThanACellsDiagonalAndKeepTheirColors) {
  const TriangleMesh thinned = cluster_vertices(make_torus(200, 80), 0.01F);
  for (Eigen::Index i = 0; i < thinned.vertices.rows(); ++i) {
    const Eigen::Vector3f p = thinned.vertices.row(i).transpose();
    const float off = std::hypot(p.head<2>().norm() - 0.1F, p.z()) - 0.04F;
    EXPECT_LT(std::abs(off), 0.01F);
    EXPECT_NEAR(thinned.colors(i, 0), 127.0F + 120.0F * p.z() / 0.04F, 25.0F);
  }
}

TEST(MeshThinning, TheResultHasAboutTheAllowedNumberOfTriangles) {
  const TriangleMesh torus = make_torus(300, 120);
  for (const Index budget : {200U, 3000U, 20000U}) {
    const TriangleMesh thinned = thin(torus, budget, 0.0005F);
    EXPECT_LE(thinned.triangles.rows(), budget);
    EXPECT_GT(thinned.triangles.rows(), budget / 4);
  }
  EXPECT_EQ(thin(torus, 0, 0.001F).triangles.rows(), 0);
}

TEST(MeshThinning, ASmallMeshIsUnchanged) {
  const TriangleMesh torus = make_torus(30, 12);
  const TriangleMesh same = thin(torus, static_cast<Index>(torus.triangles.rows()), 0.05F);
  EXPECT_EQ(same.vertices, torus.vertices);
  EXPECT_EQ(same.triangles, torus.triangles);
}

TEST(MeshThinning, TheSidesOfAWallThinnerThanACellStayApart) {
  TriangleMesh wall = make_torus(100, 40);
  wall.vertices.col(2) *= 0.05F;  // 4 mm
  const TriangleMesh thinned = cluster_vertices(wall, 0.01F);
  EXPECT_GT(thinned.vertices.col(2).maxCoeff(), 0.0008F);
  EXPECT_LT(thinned.vertices.col(2).minCoeff(), -0.0008F);
}

TEST(MeshThinning, ACropHasTheTrianglesInTheBallAndNoOtherVertices) {
  TriangleMesh torus = make_torus(100, 40);
  torus.normals = vertex_normals(torus);
  torus.vertices(5, 0) = std::numeric_limits<float>::quiet_NaN();
  const Ball ball{{0.1F, 0.0F, 0.0F}, 0.06F};
  const TriangleMesh part = crop(torus, ball);
  ASSERT_GT(part.triangles.rows(), 100);
  EXPECT_LT(part.triangles.rows(), torus.triangles.rows());
  EXPECT_EQ(part.normals.rows(), part.vertices.rows());
  EXPECT_EQ(part.colors.rows(), part.vertices.rows());
  EXPECT_LT(part.triangles.maxCoeff(), part.vertices.rows());
  for (Eigen::Index i = 0; i < part.vertices.rows(); ++i) {
    EXPECT_LE((part.vertices.row(i).transpose() - ball.center).norm(), ball.radius);
  }
  EXPECT_EQ(crop(torus, {{9.0F, 0.0F, 0.0F}, 1.0F}).vertices.rows(), 0);
}

TEST(MeshThinning, NormalsPointOutOfTheSurface) {
  const TriangleMesh torus = make_torus(100, 40);
  const Points normals = vertex_normals(torus);
  for (Eigen::Index i = 0; i < normals.rows(); ++i) {
    const Eigen::Vector3f p = torus.vertices.row(i).transpose();
    const Eigen::Vector3f ring(0.1F * p.x() / p.head<2>().norm(), 0.1F * p.y() / p.head<2>().norm(),
                               0.0F);
    EXPECT_GT(normals.row(i).dot((p - ring).normalized().transpose()), 0.99F);
  }
}

}  // namespace
}  // namespace symscene
