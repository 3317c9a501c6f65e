#include "io/thinned_surfaces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace symscene {
namespace {

/// A sphere of `steps` rings.
TriangleMesh sphere(float radius, int steps) {
  TriangleMesh mesh;
  mesh.vertices.resize((steps + 1) * 2 * steps, 3);
  mesh.triangles.resize(4 * steps * steps, 3);
  const auto at = [&](int ring, int s) {
    return static_cast<Index>(ring * 2 * steps + s % (2 * steps));
  };
  Eigen::Index row = 0;
  for (int ring = 0; ring <= steps; ++ring) {
    for (int s = 0; s < 2 * steps; ++s) {
      const float tilt = 3.1415927F * static_cast<float>(ring) / static_cast<float>(steps);
      const float turn = 3.1415927F * static_cast<float>(s) / static_cast<float>(steps);
      mesh.vertices.row(at(ring, s)) << radius * std::sin(tilt) * std::cos(turn),
          radius * std::sin(tilt) * std::sin(turn), radius * std::cos(tilt);
      if (ring == steps) continue;
      mesh.triangles.row(row++) << at(ring, s), at(ring + 1, s), at(ring + 1, s + 1);
      mesh.triangles.row(row++) << at(ring, s), at(ring + 1, s + 1), at(ring, s + 1);
    }
  }
  return mesh;
}

/// The least distance of a point from all triangles.
double distance_to(const TriangleMesh& mesh, const Eigen::Vector3d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    std::array<Eigen::Vector3d, 3> corners;
    for (int k = 0; k < 3; ++k)
      corners[static_cast<std::size_t>(k)] =
          mesh.vertices.row(mesh.triangles(t, k)).transpose().cast<double>();
    least = std::min(least, distance_to_triangle(point, corners[0], corners[1], corners[2]));
  }
  return least;
}

TEST(ThinnedSurfaces, KeepsTheBoundOnTrianglesAndTellsTheTrueError) {
  for (const float radius : {0.02F, 0.1F, 1.0F}) {
    const std::vector<TriangleMesh> full{sphere(radius, 30), sphere(0.5F * radius, 4)};
    const ThinnedSurfaces thinned = thinned_surfaces(full, 600);
    ASSERT_EQ(thinned.meshes.size(), 2U);
    EXPECT_LE(thinned.triangles, 600U);
    EXPECT_EQ(thinned.meshes[1].triangles.rows(), full[1].triangles.rows());
    double greatest = 0.0;
    for (Eigen::Index i = 0; i < full[0].vertices.rows(); ++i)
      greatest = std::max(
          greatest,
          distance_to(thinned.meshes[0], full[0].vertices.row(i).transpose().cast<double>()));
    EXPECT_NEAR(greatest, thinned.error, 1e-9);
    EXPECT_GT(thinned.error, 0.0);
    EXPECT_GT(thinned.usual_error, 0.0);
    EXPECT_LT(thinned.error, 0.1 * radius);
  }
}

TEST(ThinnedSurfaces, LeavesEmptySurfacesAlone) {
  const std::vector<TriangleMesh> full(3);
  const ThinnedSurfaces thinned = thinned_surfaces(full, 10);
  EXPECT_EQ(thinned.meshes.size(), 3U);
  EXPECT_EQ(thinned.error, 0.0);
  EXPECT_TRUE(thinned_surfaces({}, 10).meshes.empty());
}

/// Against the least distance of many points of the triangle.
TEST(ThinnedSurfaces, TheDistanceToATriangleIsThatToItsNearestPoint) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> within(-1.0, 1.0);
  const auto point = [&] {
    return Eigen::Vector3d(within(random), within(random), within(random));
  };
  for (int round = 0; round < 30; ++round) {
    const Eigen::Vector3d a = point(), b = point(), c = round == 0 ? a : point(), p = point();
    double least = std::numeric_limits<double>::infinity();
    constexpr int steps = 60;
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j)
        least = std::min(least, (a + i * (b - a) / steps + j * (c - a) / steps - p).norm());
    EXPECT_LE(distance_to_triangle(p, a, b, c), least + 1e-12);
    EXPECT_NEAR(distance_to_triangle(p, a, b, c), least, 0.05);
  }
}

}  // namespace
}  // namespace symscene
