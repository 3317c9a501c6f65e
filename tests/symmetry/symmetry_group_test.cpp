#include "symscene/symmetry/symmetry_group.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "surfaces.hpp"
#include "symmetry/group_orders.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/thread_limit.hpp"

namespace symscene {
namespace {

constexpr std::size_t sampled_points = 12000;
const double max_angle = radians(1.0);
constexpr double max_distance = 0.01;  ///< by the diameter

/// Sanitizers make the search twenty times slower: there it is a coarser one.
SymmetryGroupOptions options() {
  SymmetryGroupOptions options;
#ifdef SYMSCENE_SANITIZED
  options.directions = 600;
  options.coarse_points = 60;
  options.fit_points = 100;
  options.residual_points = 200;
#endif
  return options;
}

PointCloud surface_of(const TriangleMesh& mesh) { return sample_surface(mesh, sampled_points); }

TriangleMesh box(const Eigen::Vector3d& size) { return make_box(size, size.maxCoeff() / 10.0); }

TriangleMesh can() {
  const std::vector<ProfilePoint> profile{{0.0, 0.0}, {0.04, 0.0}, {0.04, 0.12}, {0.0, 0.12}};
  return make_revolution(profile, 64, 0.01);
}

TriangleMesh cone() {
  const std::vector<ProfilePoint> profile{{0.0, 0.0}, {0.05, 0.0}, {0.0, 0.12}};
  return make_revolution(profile, 64, 0.01);
}

/// A bar with a base of `sides` corners.
TriangleMesh bar(int sides) {
  const std::vector<ProfilePoint> profile{{0.0, 0.0}, {0.05, 0.0}, {0.05, 0.15}, {0.0, 0.15}};
  return make_revolution(profile, sides, 0.2);
}

/// A cup with a handle in the plane y = 0.
TriangleMesh mug(const Eigen::Vector3d& handle) {
  const std::vector<Ellipsoid> parts{{{0.0, 0.0, 0.05}, {0.04, 0.04, 0.06}},
                                     {{0.05, 0.0, 0.08}, handle}};
  return make_mirrored_body(parts, 0.002, 0.004);
}

TriangleMesh mug() { return mug({0.03, 0.01, 0.02}); }

/// A ball with a radius of 5 cm, stretched along z.
PointCloud spheroid(double stretch) {
  std::vector<ProfilePoint> profile;
  for (int k = 0; k <= 32; ++k) {
    const double angle = std::numbers::pi * (k / 32.0 - 0.5);
    profile.push_back(
        {k % 32 == 0 ? 0.0 : 0.05 * std::cos(angle), 0.05 * stretch * std::sin(angle)});
  }
  return surface_of(make_revolution(profile, 64, 0.01));
}

/// Three boxes of different sizes, in general position.
PointCloud heap() {
  const auto placed = [](const Eigen::Vector3d& size, const Eigen::Vector3d& place) {
    const Eigen::Isometry3d shift(Eigen::Translation3d{place});
    return testing::moved(sample_surface(box(size), 4000), shift);
  };
  return testing::joined(placed({0.1, 0.06, 0.1}, {0.0, 0.0, 0.0}),
                         testing::joined(placed({0.05, 0.03, 0.08}, {0.06, 0.05, 0.03}),
                                         placed({0.02, 0.07, 0.03}, {-0.05, 0.03, 0.08})));
}

struct Expected {
  const char* name;
  PointCloud surface;
  std::vector<int> orders;
  std::size_t planes;
  std::size_t rotations;
};

TEST(SymmetryGroup, IsThatOfSolidsAtAnyScaleAndPlace) {
  const std::vector<Expected> solids = {
      {"box", surface_of(box({0.1, 0.16, 0.23})), {2, 2, 2}, 3, 3},
      {"square bar", surface_of(bar(4)), {4, 2, 2, 2, 2}, 5, 7},
      {"hexagonal bar", surface_of(bar(6)), {6, 2, 2, 2, 2, 2, 2}, 7, 11},
      {"cube", surface_of(box({0.1, 0.1, 0.1})), {4, 4, 4, 3, 3, 3, 3, 2, 2, 2, 2, 2, 2}, 9, 23},
      {"can", surface_of(can()), {GroupAxis::continuous, 2}, 1, 1},
      {"cone", surface_of(cone()), {GroupAxis::continuous}, 0, 0},
      {"mug", surface_of(mug()), {}, 1, 0},
      {"heap", heap(), {}, 0, 0},
  };
  std::mt19937 generator(4);
  for (const Expected& solid : solids) {
    for (const double scale : {1.0, 1000.0}) {
      const Eigen::Isometry3d motion = testing::random_motion(generator);
      PointCloud moved = testing::moved(solid.surface, motion);
      moved.positions *= static_cast<float>(scale);
      const SymmetryGroup found = find_symmetry_group(moved, options());
      EXPECT_EQ(orders_of(found), solid.orders) << solid.name << ", scale " << scale;
      EXPECT_EQ(found.planes.size(), solid.planes) << solid.name << ", scale " << scale;
      EXPECT_EQ(found.rotations.size(), solid.rotations) << solid.name << ", scale " << scale;
      EXPECT_FALSE(found.sphere);
      for (const GroupPlane& plane : found.planes)
        EXPECT_LE(plane.residual, 0.01 * found.diagonal) << solid.name;
    }
  }
}

TEST(SymmetryGroup, HasThePlanesAndAxesOfABoxWhereTheyAre) {
  std::mt19937 generator(5);
  const Eigen::Isometry3d motion = testing::random_motion(generator);
  const SymmetryGroup found =
      find_symmetry_group(testing::moved(surface_of(box({0.1, 0.16, 0.23})), motion), options());
  const Eigen::Vector3d middle = motion * Eigen::Vector3d(0.0, 0.0, 0.115);
  EXPECT_LT((found.center - middle).norm(), max_distance * found.diameter);
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d direction = motion.linear().col(k);
    const auto is_along = [&](const Eigen::Vector3d& other) {
      return line_angle(direction, other) < max_angle;
    };
    EXPECT_TRUE(std::any_of(found.planes.begin(), found.planes.end(), [&](const auto& plane) {
      return is_along(plane.plane.normal) &&
             std::abs(plane.plane.signed_distance(middle)) < max_distance * found.diameter;
    })) << k;
    EXPECT_TRUE(std::any_of(found.axes.begin(), found.axes.end(), [&](const auto& axis) {
      return is_along(axis.axis.direction) &&
             axis.axis.distance(middle) < max_distance * found.diameter;
    })) << k;
  }
}

TEST(SymmetryGroup, RotationsAreAnExactGroup) {
  const SymmetryGroup found = find_symmetry_group(surface_of(bar(6)), options());
  std::vector<Eigen::Isometry3d> all = found.rotations;
  all.push_back(Eigen::Isometry3d::Identity());
  for (const Eigen::Isometry3d& a : all) {
    EXPECT_NEAR(a.linear().determinant(), 1.0, 1e-12);
    for (const Eigen::Isometry3d& b : all) {
      const Eigen::Isometry3d product = a * b;
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Eigen::Isometry3d& other) {
        return (product.matrix() - other.matrix()).norm() < 1e-9;
      }));
    }
  }
}

TEST(SymmetryGroup, ATighterToleranceDropsTheDiagonalsOfANearlySquareBox) {
  const PointCloud cloud = surface_of(box({0.1, 0.103, 0.2}));
  SymmetryGroupOptions loose = options(), tight = options();
  loose.tolerance = 0.02;
  tight.tolerance = 0.002;
  EXPECT_EQ(find_symmetry_group(cloud, loose).axes.front().order, 4);
  EXPECT_EQ(orders_of(find_symmetry_group(cloud, tight)), (std::vector<int>{2, 2, 2}));
}

TEST(SymmetryGroup, APlateThatIsNotSquareHasNoDiagonals) {
  const SymmetryGroup found = find_symmetry_group(surface_of(box({0.1, 0.11, 0.005})), options());
  EXPECT_EQ(orders_of(found), (std::vector<int>{2, 2, 2}));
  EXPECT_EQ(found.planes.size(), 3U);
  EXPECT_EQ(found.rotations.size(), 3U);
  const SymmetryGroup square = find_symmetry_group(surface_of(box({0.1, 0.1, 0.005})), options());
  EXPECT_EQ(orders_of(square), (std::vector<int>{4, 2, 2, 2, 2}));
  EXPECT_EQ(square.planes.size(), 5U);
  EXPECT_EQ(square.rotations.size(), 7U);
}

TEST(SymmetryGroup, DoesNotTurnASmallHandleOffTheSurface) {
  const PointCloud cloud = surface_of(mug({0.04, 0.005, 0.005}));
  SymmetryGroupOptions by_mean_alone = options();
  by_mean_alone.part_share = 1.0;
  const std::vector<int> by_mean = orders_of(find_symmetry_group(cloud, by_mean_alone));
  ASSERT_FALSE(by_mean.empty());
  EXPECT_EQ(by_mean.front(), GroupAxis::continuous);
  const SymmetryGroup found = find_symmetry_group(cloud, options());
  EXPECT_TRUE(found.axes.empty());
  ASSERT_EQ(found.planes.size(), 1U);
  EXPECT_LT(line_angle(found.planes.front().plane.normal, Eigen::Vector3d::UnitY()), max_angle);
}

TEST(SymmetryGroup, ASlenderBarDoesNotTurnFreely) {
  const PointCloud cloud = surface_of(box({0.01, 0.02, 0.6}));
  // The coarse search of sanitized tests misses a plane of so slender a bar.
  const SymmetryGroupOptions defaults;
  SymmetryGroupOptions by_diagonal_alone = defaults;
  by_diagonal_alone.radius_share = 1.0;
  const std::vector<int> by_diagonal = orders_of(find_symmetry_group(cloud, by_diagonal_alone));
  ASSERT_FALSE(by_diagonal.empty());
  EXPECT_EQ(by_diagonal.front(), GroupAxis::continuous);
  const SymmetryGroup found = find_symmetry_group(cloud, defaults);
  EXPECT_EQ(found.planes.size(), 3U);
  EXPECT_EQ(found.rotations.size(), 3U);
  for (const GroupAxis& axis : found.axes) EXPECT_EQ(axis.order, 2);
}

TEST(SymmetryGroup, DiagonalIsThatOfABoxInAnyPose) {
  const Eigen::Vector3d size(0.1, 0.16, 0.23);
  const PointCloud cloud = surface_of(box(size));
  std::mt19937 generator(6);
  for (int round = 0; round < 5; ++round) {
    const SymmetryGroup found =
        find_symmetry_group(testing::moved(cloud, testing::random_motion(generator)), options());
    EXPECT_NEAR(found.diagonal, size.norm(), 0.01 * size.norm());
  }
}

TEST(SymmetryGroup, OfABallIsASphere) {
  const SymmetryGroup found = find_symmetry_group(spheroid(1.0));
  EXPECT_TRUE(found.sphere);
  EXPECT_LT(found.center.norm(), 0.001);
  EXPECT_NEAR(found.diameter, 0.1, 0.001);
  EXPECT_TRUE(found.axes.empty());
}

TEST(SymmetryGroup, ASphereIsJudgedByItsDiagonal) {
  // The mean deviation of the radii is 0.128 of the stretch by the diameter, the tolerance 0.0173.
  EXPECT_TRUE(find_symmetry_group(spheroid(1.1)).sphere);
  EXPECT_FALSE(find_symmetry_group(spheroid(1.18), options()).sphere);
}

TEST(SymmetryGroup, GivesTheSameBitsForAnyNumberOfThreads) {
  const PointCloud cloud = surface_of(bar(6));
  SymmetryGroup alone;
  {
    const ThreadLimit one(1);
    alone = find_symmetry_group(cloud, options());
  }
  const SymmetryGroup together = find_symmetry_group(cloud, options());
  ASSERT_EQ(alone.planes.size(), together.planes.size());
  for (std::size_t k = 0; k < alone.planes.size(); ++k)
    EXPECT_EQ(alone.planes[k].plane.normal, together.planes[k].plane.normal);
}

TEST(SymmetryGroup, OfACloudWithoutNormalsIsThatOfItsSurface) {
  PointCloud cloud = surface_of(box({0.1, 0.16, 0.23}));
  cloud.normals.resize(0, 3);
  EXPECT_EQ(find_symmetry_group(even_surface(cloud), options()).planes.size(), 3U);
}

TEST(SymmetryGroup, RefusesWhatIsNoSurface) {
  const PointCloud cloud = surface_of(bar(4));
  EXPECT_THROW(find_symmetry_group(PointCloud{}), InputError);
  EXPECT_THROW(even_surface(select(cloud, PointIndices{0})), InputError);
  PointCloud bare = cloud;
  bare.normals.resize(0, 3);
  EXPECT_THROW(find_symmetry_group(bare), InputError);
  SymmetryGroupOptions wrong;
  wrong.tolerance = 0.0;
  EXPECT_THROW(find_symmetry_group(cloud, wrong), InputError);
}

}  // namespace
}  // namespace symscene
