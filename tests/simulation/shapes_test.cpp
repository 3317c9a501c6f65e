#include "simulation/shapes.hpp"

#include <gtest/gtest.h>

#include <map>

#include "core/vertex_normals.hpp"
#include "simulation/household_object.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr ObjectKind all_kinds[] = {ObjectKind::box,  ObjectKind::can,    ObjectKind::lying_can,
                                    ObjectKind::bowl, ObjectKind::bottle, ObjectKind::cup,
                                    ObjectKind::toy};

double signed_volume(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Eigen::Vector3d a = mesh.vertices.row(mesh.triangles(t, 0)).transpose().cast<double>();
    const Eigen::Vector3d b = mesh.vertices.row(mesh.triangles(t, 1)).transpose().cast<double>();
    const Eigen::Vector3d c = mesh.vertices.row(mesh.triangles(t, 2)).transpose().cast<double>();
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

/// Every edge is used once in each direction: the mesh is closed and consistently wound.
bool is_closed(const TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, int> edges;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (int k = 0; k < 3; ++k) ++edges[{mesh.triangles(t, k), mesh.triangles(t, (k + 1) % 3)}];
  }
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) return false;
  }
  return true;
}

/// The farthest that an image of a vertex lies from the nearest vertex.
template <class Image>
double vertex_deviation(const TriangleMesh& mesh, const Image& image) {
  const CellList cells(mesh.vertices, 0.01F);
  double farthest = 0.0;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    const Eigen::Vector3d p = mesh.vertices.row(i).transpose().cast<double>();
    const auto [index, squared] = cells.nearest(image(p).template cast<float>(), 0.05F);
    if (index == CellList::none) return 1.0;
    farthest = std::max(farthest, std::sqrt(static_cast<double>(squared)));
  }
  return farthest;
}

TEST(Shapes, BoxHasItsSizeAndVolume) {
  const TriangleMesh box = make_box({0.1, 0.2, 0.3}, 0.03);
  EXPECT_TRUE(is_closed(box));
  EXPECT_NEAR(signed_volume(box), 0.006, 1e-8);
  EXPECT_NEAR(box.vertices.col(2).minCoeff(), 0.0, 1e-7);
  EXPECT_LT((volume_centroid(box) - Eigen::Vector3d(0, 0, 0.15)).norm(), 1e-6);
}

TEST(Shapes, RevolvedCylinderHasTheVolumeOfItsPolygon) {
  const ProfilePoint profile[] = {{0, 0}, {0.05, 0}, {0.05, 0.1}, {0, 0.1}};
  const TriangleMesh cylinder = make_revolution(profile, 96, 0.01);
  EXPECT_TRUE(is_closed(cylinder));
  EXPECT_NEAR(signed_volume(cylinder), std::numbers::pi * 0.05 * 0.05 * 0.1, 1e-6);
}

TEST(Shapes, ATransformedMeshHasRotatedNormals) {
  TriangleMesh box = make_box({0.1, 0.2, 0.3}, 1.0);
  box.normals = vertex_normals(box);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(Eigen::Vector3d(1.0, 2.0, 3.0));
  motion.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -1.0).normalized()));
  const TriangleMesh moved = transformed(box, motion);
  EXPECT_LT((moved.normals - vertex_normals(moved)).cwiseAbs().maxCoeff(), 1e-5F);
  EXPECT_EQ(transformed(make_box({0.1, 0.2, 0.3}, 1.0), motion).normals.rows(), 0);
}

TEST(Shapes, InsideMeansInsideTheSolidNotInItsHollow) {
  const ProfilePoint cup[] = {{0, 0},       {0.04, 0},      {0.04, 0.1},
                              {0.037, 0.1}, {0.037, 0.005}, {0, 0.005}};
  const TriangleMesh mesh = make_revolution(cup, 96, 0.01);
  EXPECT_TRUE(is_inside(mesh, {0.0385, 0, 0.05}));
  EXPECT_FALSE(is_inside(mesh, {0, 0, 0.05}));
  EXPECT_FALSE(is_inside(mesh, {0.05, 0, 0.05}));
}

TEST(HouseholdObject, EveryKindIsAClosedSolidOfHouseholdSizeThatStandsOnTheTable) {
  for (const ObjectKind kind : all_kinds) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(std::string(to_string(kind)) + " seed " + std::to_string(seed));
      Random random(seed);
      const HouseholdObject object = make_household_object(kind, random);
      EXPECT_TRUE(is_closed(object.mesh));
      EXPECT_GT(signed_volume(object.mesh), 1e-5);
      const Eigen::RowVector3f size =
          object.mesh.vertices.colwise().maxCoeff() - object.mesh.vertices.colwise().minCoeff();
      EXPECT_GT(size.maxCoeff(), 0.05F);
      EXPECT_LT(size.maxCoeff(), 0.32F);
      EXPECT_NEAR(object.mesh.vertices.col(2).minCoeff(), 0.0, 2e-4);
    }
  }
}

TEST(HouseholdObject, ReflectionInATruePlaneGivesTheSameMesh) {
  for (const ObjectKind kind : all_kinds) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Random random(seed);
      const HouseholdObject object = make_household_object(kind, random);
      for (const TruePlane& truth : object.reflectional) {
        const double deviation = vertex_deviation(
            object.mesh, [&](const Eigen::Vector3d& p) { return truth.plane.reflect_point(p); });
        EXPECT_LT(deviation, truth.strict ? 1e-5 : 2e-3) << to_string(kind) << " seed " << seed;
      }
    }
  }
}

TEST(HouseholdObject, RotationAboutATrueAxisGivesTheSameMesh) {
  for (const ObjectKind kind : all_kinds) {
    Random random(3);
    const HouseholdObject object = make_household_object(kind, random);
    for (const TrueAxis& truth : object.rotational) {
      const double step = 2.0 * std::numbers::pi / 96.0;
      for (const int steps : {1, 7, 48}) {
        EXPECT_LT(vertex_deviation(object.mesh,
                                   [&](const Eigen::Vector3d& p) {
                                     return truth.axis.rotate_point(p, steps * step);
                                   }),
                  1e-5)
            << to_string(kind);
      }
    }
  }
}

TEST(HouseholdObject, EveryKindHasAStrictSymmetry) {
  for (const ObjectKind kind : all_kinds) {
    Random random(11);
    const HouseholdObject object = make_household_object(kind, random);
    EXPECT_TRUE(!object.rotational.empty() || object.reflectional.front().strict);
  }
}

}  // namespace
}  // namespace symscene
