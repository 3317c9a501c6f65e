#include "reconstruction/surface_extraction.hpp"

#include <gtest/gtest.h>

#include <map>

#include "reconstruction/analytic_scenes.hpp"
#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

constexpr double mesh_voxel = 0.0031;

/// Directed edges of a mesh and how often triangles take them.
std::map<std::pair<Index, Index>, int> edges_of(const TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, int> edges;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (int c = 0; c < 3; ++c) ++edges[{mesh.triangles(t, c), mesh.triangles(t, (c + 1) % 3)}];
  }
  return edges;
}

/// Every edge has two triangles, which take it in opposite directions.
void expect_watertight(const TriangleMesh& mesh) {
  std::size_t bad = 0;
  const auto edges = edges_of(mesh);
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    bad += count != 1 || back == edges.end() ? 1 : 0;
  }
  EXPECT_EQ(bad, 0U) << "of " << edges.size() << " edges";
}

/// No edge is taken twice in one direction.
void expect_manifold(const TriangleMesh& mesh) {
  for (const auto& [edge, count] : edges_of(mesh)) ASSERT_EQ(count, 1);
}

long euler_characteristic(const TriangleMesh& mesh) {
  return mesh.vertices.rows() - static_cast<long>(edges_of(mesh).size()) / 2 +
         mesh.triangles.rows();
}

Eigen::Vector3d vertex(const TriangleMesh& mesh, Eigen::Index i) {
  return mesh.vertices.row(i).transpose().cast<double>();
}

Eigen::Vector3d normal(const TriangleMesh& mesh, Eigen::Index i) {
  return mesh.normals.row(i).transpose().cast<double>();
}

/// Twice the area of a triangle times its normal.
Eigen::Vector3d area_vector(const TriangleMesh& mesh, Eigen::Index t) {
  const Eigen::Vector3d a = vertex(mesh, mesh.triangles(t, 0));
  return (vertex(mesh, mesh.triangles(t, 1)) - a).cross(vertex(mesh, mesh.triangles(t, 2)) - a);
}

void expect_normals_agree_with_triangles(const TriangleMesh& mesh) {
  Eigen::Index against = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (int c = 0; c < 3; ++c) {
      against += area_vector(mesh, t).dot(normal(mesh, mesh.triangles(t, c))) < -1e-12 ? 1 : 0;
    }
  }
  EXPECT_LT(against, mesh.triangles.rows() / 200);
}

const Eigen::Vector3d center(0.013, -0.021, 0.034);

TriangleMesh ball_mesh() {
  static const TriangleMesh mesh =
      extract_surface(seen_from_everywhere({sphere(center, 0.1)}, center, 40));
  return mesh;
}

TEST(SurfaceExtraction, ClosesABallSeenFromAllSides) {
  const TriangleMesh mesh = ball_mesh();
  EXPECT_GT(mesh.triangles.rows(), 20000);
  expect_watertight(mesh);
  EXPECT_EQ(euler_characteristic(mesh), 2);
}

TEST(SurfaceExtraction, PutsVerticesOnTheBallAndNormalsOutwards) {
  const TriangleMesh mesh = ball_mesh();
  double squares = 0.0;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const Eigen::Vector3d out = vertex(mesh, i) - center;
    EXPECT_NEAR(out.norm(), 0.1, 0.5 * mesh_voxel);
    EXPECT_GT(out.normalized().dot(normal(mesh, i)), 0.8);
    EXPECT_NEAR(normal(mesh, i).norm(), 1.0, 1e-5);
    squares += std::pow(out.norm() - 0.1, 2);
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(mesh.vertices.rows())), 0.1 * mesh_voxel);
  expect_normals_agree_with_triangles(mesh);
}

TEST(SurfaceExtraction, EnclosesTheVolumeOfTheBall) {
  const TriangleMesh mesh = ball_mesh();
  double volume = 0.0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    volume += area_vector(mesh, t).dot(vertex(mesh, mesh.triangles(t, 0)) - center) / 6.0;
  }
  EXPECT_NEAR(volume, 4.0 / 3.0 * std::numbers::pi * 1e-3, 0.02 * 4.19e-3);
}

TEST(SurfaceExtraction, ClosesALongBodyThatIsTurned) {
  const Bodies egg{ellipsoid(motion({0.4, -0.7, 1.1}, center), {0.1, 0.05, 0.07})};
  const TriangleMesh mesh = extract_surface(seen_from_everywhere(egg, center, 50));
  EXPECT_GT(mesh.triangles.rows(), 5000);
  expect_watertight(mesh);
  EXPECT_EQ(euler_characteristic(mesh), 2);
  expect_normals_agree_with_triangles(mesh);
}

TEST(SurfaceExtraction, PutsVerticesOnATurnedBoxAndClosesItAtItsEdges) {
  const Eigen::Isometry3d T_world_box = motion({0.3, -0.5, 0.8}, center);
  const Eigen::Vector3d half(0.08, 0.06, 0.05);
  const TriangleMesh mesh =
      extract_surface(seen_from_everywhere({box(T_world_box, half)}, center, 60));
  expect_watertight(mesh);
  const auto beyond = [&](Eigen::Index i) {
    return Eigen::Vector3d((T_world_box.inverse() * vertex(mesh, i)).cwiseAbs() - half);
  };
  std::size_t off = 0;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const Eigen::Vector3d p = beyond(i);
    const double distance = p.cwiseMax(0.0).norm() + std::min(p.maxCoeff(), 0.0);
    EXPECT_LT(std::abs(distance), 2.0 * mesh_voxel);
    off += std::abs(distance) > 0.5 * mesh_voxel ? 1 : 0;
  }
  EXPECT_LT(off, static_cast<std::size_t>(mesh.vertices.rows()) / 10);
}

/// What is seen at a flat angle is measured down to a smaller depth below it than a cell has.
TEST(SurfaceExtraction, HasNoHolesInAPlaneSeenAtAFlatAngle) {
  TsdfVolume volume;
  const double tilt = radians(70.0);
  const Eigen::Vector3d normal(std::sin(tilt), 0.0, -std::cos(tilt));
  const CameraIntrinsics camera{640, 480, 560.0, 560.0, 319.5, 239.5};
  fuse(volume, {plane(normal, 0.6 * std::cos(tilt))}, camera, Eigen::Isometry3d::Identity());
  const TriangleMesh mesh = extract_surface(volume);
  ASSERT_GT(mesh.triangles.rows(), 1000);
  const auto edges = edges_of(mesh);
  const auto is_inside = [&](Index i) {
    return (vertex(mesh, i) - Eigen::Vector3d(0, 0, 0.6)).norm() < 0.06;
  };
  for (const auto& [edge, count] : edges) {
    if (!is_inside(edge.first) || !is_inside(edge.second)) continue;
    EXPECT_TRUE(edges.contains({edge.second, edge.first})) << "a hole";
  }
}

TEST(SurfaceExtraction, ClosesTwoBodiesEachByItself) {
  const Bodies balls{sphere({-0.06, 0, 0}, 0.04), sphere({0.06, 0, 0}, 0.035)};
  const TriangleMesh mesh =
      extract_surface(seen_from_everywhere(balls, Eigen::Vector3d::Zero(), 70));
  expect_watertight(mesh);
  EXPECT_EQ(euler_characteristic(mesh), 4);
}

TEST(SurfaceExtraction, HasNoSurfaceAtTheBorderOfUnseenSpace) {
  TsdfVolume volume;
  const CameraIntrinsics camera = small_camera();
  const Eigen::Isometry3d pose = look_at(center + Eigen::Vector3d(0, 0, 0.6), center);
  fuse(volume, {sphere(center, 0.1)}, camera, pose);
  const TriangleMesh mesh = extract_surface(volume);
  EXPECT_GT(mesh.vertices.rows(), 1000);
  expect_manifold(mesh);
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const Eigen::Vector3d out = vertex(mesh, i) - center;
    EXPECT_NEAR(out.norm(), 0.1, 1.5 * mesh_voxel);
    EXPECT_GT(out.dot(pose.translation() - vertex(mesh, i)), 0.0) << "seen from behind";
  }
  EXPECT_EQ(extract_surface(TsdfVolume()).vertices.rows(), 0);
  EXPECT_EQ(extract_surface(TsdfVolume()).normals.rows(), 0);
}

TEST(SurfaceExtraction, IsManifoldOnAClutteredTableToo) {
  TsdfVolume volume;
  for (const double angle : {0.0, 0.7, 1.4, 2.1}) {
    fuse(volume, tabletop(), small_camera(), around_table(angle));
  }
  const TriangleMesh mesh = extract_surface(volume);
  EXPECT_GT(mesh.vertices.rows(), 10000);
  expect_manifold(mesh);
  expect_normals_agree_with_triangles(mesh);
  EXPECT_LT(mesh.triangles.maxCoeff(), static_cast<Index>(mesh.vertices.rows()));
}

TEST(SurfaceExtraction, OfOneFrameIsWholeAtAnyDistance) {
  for (const double distance : {0.4, 0.9, 2.0, 2.9}) {
    TsdfVolume volume;
    fuse(volume, {plane(-Eigen::Vector3d::UnitZ(), distance)}, small_camera(),
         Eigen::Isometry3d::Identity());
    const TriangleMesh mesh = extract_surface(volume);
    const double area = distance * distance * (160.0 / 140.0) * (120.0 / 141.0);
    const double voxels = static_cast<double>(mesh.vertices.rows()) * mesh_voxel * mesh_voxel;
    EXPECT_GT(voxels, 0.85 * area) << distance;
  }
}

TEST(SurfaceExtraction, AsksForLooksWhateverTheyWeighAtTheirDistance) {
  SurfaceExtractionOptions two_looks;
  two_looks.min_looks = 1.5;
  two_looks.full_frames = 1;
  for (const double distance : {0.6, 1.0, 1.9}) {
    TsdfVolume volume;
    const auto look = [&] {
      fuse(volume, {plane(-Eigen::Vector3d::UnitZ(), distance)}, small_camera(),
           Eigen::Isometry3d::Identity());
    };
    look();
    EXPECT_EQ(extract_surface(volume, two_looks).vertices.rows(), 0) << distance;
    look();
    EXPECT_GT(extract_surface(volume, two_looks).vertices.rows(), 1000) << distance;
  }
}

TEST(SurfaceExtraction, DropsSmallPieces) {
  const Bodies balls{sphere({-0.05, 0, 0}, 0.035), sphere({0.05, 0, 0}, 0.012)};
  const TsdfVolume volume = seen_from_everywhere(balls, Eigen::Vector3d::Zero(), 50);
  SurfaceExtractionOptions options;
  options.min_triangles = 1000;
  const TriangleMesh mesh = extract_surface(volume, options);
  expect_watertight(mesh);
  EXPECT_EQ(euler_characteristic(mesh), 2);
  EXPECT_LT(mesh.vertices.col(0).maxCoeff(), 0.0F);
  options.min_triangles = 1;
  EXPECT_GT(extract_surface(volume, options).vertices.col(0).maxCoeff(), 0.04F);
  options.min_triangles = 10'000'000;
  EXPECT_EQ(extract_surface(volume, options).triangles.rows(), 0);
}

TEST(SurfaceExtraction, ColorsVerticesAsTheFrames) {
  TsdfVolume volume;
  for (int k = 0; k < 4; ++k) {
    DepthFrame frame = flat_frame(small_camera(), 0.8F);
    paint(frame, 250, 128, 3);
    volume.integrate(prepare_measurement(frame, small_camera(), {}), Eigen::Isometry3d::Identity());
  }
  const TriangleMesh mesh = extract_surface(volume);
  ASSERT_GT(mesh.colors.rows(), 1000);
  for (Eigen::Index i = 0; i < mesh.colors.rows(); ++i) {
    ASSERT_EQ(mesh.colors.row(i), (Eigen::Matrix<std::uint8_t, 1, 3>(250, 128, 3)));
  }
  EXPECT_EQ(ball_mesh().colors.rows(), 0);
}

TEST(SurfaceExtraction, IsTheSameForAnyNumberOfThreads) {
  const TsdfVolume volume = seen_from_everywhere(tabletop(), {0, 0, 0.05}, 6);
  const auto run = [&] { return extract_surface(volume); };
  const TriangleMesh one = with_threads(1, run);
  EXPECT_GT(one.triangles.rows(), 1000);
  EXPECT_TRUE(same(with_threads(2, run), one));
  EXPECT_TRUE(same(with_threads(4, run), one));
}

}  // namespace
}  // namespace symscene
