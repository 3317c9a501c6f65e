#include "tabletop/support_plane.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "symscene/core/error.hpp"
#include "tabletop/table_clouds.hpp"
#include "tabletop/table_search.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

/// Sanitizers make each seed thirty times slower.
#ifdef SYMSCENE_SANITIZED
constexpr std::uint64_t seeds = 1;
#else
constexpr std::uint64_t seeds = 4;
#endif

/// Points all over a sphere.
PointCloud ball(Index count) {
  Random random(1);
  PointCloud cloud;
  cloud.positions.resize(count, 3);
  for (Index i = 0; i < count; ++i) {
    const Eigen::Vector3d direction(random.normal(), random.normal(), random.normal());
    cloud.positions.row(i) = direction.normalized().cast<float>().transpose();
  }
  cloud.normals = cloud.positions;
  cloud.positions *= 0.1F;
  return cloud;
}

Eigen::Isometry3d random_motion(std::uint64_t seed) {
  Random random(seed, 7);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  std::array<double, 4> q{};
  for (double& value : q) value = random.normal();  // in this order, whatever the compiler
  motion.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  motion.translation() << random.normal(), random.normal(), random.normal();
  return motion;
}

void expect_table(const SupportPlane& found, const Eigen::Isometry3d& motion, double height = 0.0) {
  const Eigen::Vector3d up = motion.linear().col(2);
  EXPECT_LT(degrees(angle_between(found.plane.normal, up)), 0.2);
  EXPECT_LT(std::abs(found.plane.signed_distance(motion * Eigen::Vector3d(0, 0, height))), 0.001);
}

TEST(SupportPlanes, ANoisyTableIsFoundInAnyFrame) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    CloudBuilder builder(seed);
    add_table(builder);
    add_objects(builder);
    const Eigen::Isometry3d motion = random_motion(seed);
    const SupportPlanes planes = find_support_planes(builder.cloud(motion));
    ASSERT_EQ(planes.status, SupportStatus::found) << "seed " << seed;
    expect_table(planes.supports[0], motion);
    EXPECT_NEAR(planes.supports[0].area, 0.96, 0.1);
    EXPECT_GT(planes.supports[0].object_area, 0.03);
    EXPECT_LT(planes.supports[0].residual, 0.003);
  }
}

TEST(SupportPlanes, TheTableScoresHigherThanTheFloor) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    CloudBuilder builder(seed);
    add_table(builder, {0, 0, 0.75});
    add_objects(builder, {0, 0, 0.75});
    builder.add_rectangle({1.6, 0, 0}, {1.6, 0, 0}, {0, 2.5, 0});
    const Eigen::Isometry3d motion = random_motion(seed + 10);
    const SupportPlanes planes = find_support_planes(
        builder.cloud(motion), {}, {.up = Eigen::Vector3d(motion.linear().col(2))});
    ASSERT_EQ(planes.status, SupportStatus::found);
    expect_table(planes.supports[0], motion, 0.75);
    EXPECT_EQ(planes.supports.size(), 2U);
  }
}

TEST(SupportPlanes, AWallLargerThanTheTableIsNoTableWhereUpIsKnown) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    CloudBuilder builder(seed);
    add_table(builder);
    add_objects(builder);
    builder.add_rectangle({0, 0.45, 0.3}, {2.5, 0, 0}, {0, 0, 1.4});
    const Eigen::Isometry3d motion = random_motion(seed + 20);
    // The mean of the cameras' −y axes is some way off the vertical.
    const Eigen::Vector3d up = motion.linear() * Eigen::Vector3d(0.2, 0.2, 1.0);
    const TableScene scene = find_table_scene(builder.cloud(motion), {}, {.up = up});
    ASSERT_EQ(scene.planes.status, SupportStatus::found);
    expect_table(scene.planes.supports[0], motion);
    ASSERT_FALSE(scene.planes.others.empty());
    EXPECT_GT(scene.planes.others[0].area, 2.0);
    const Eigen::Isometry3d back = motion.inverse();
    for (Index i = 0; i < scene.objects.cloud.size(); ++i) {
      ASSERT_LT((back * scene.objects.cloud.position(i).cast<double>()).y(), 0.4);
    }
  }
}

TEST(SupportPlanes, TwoTablesAreAmbiguous) {
  CloudBuilder builder(3);
  for (const double x : {0.0, 1.7}) {
    add_table(builder, {x, 0, 0.1 * x});
    add_objects(builder, {x, 0, 0.1 * x});
  }
  const SupportPlanes planes = find_support_planes(builder.cloud());
  ASSERT_EQ(planes.status, SupportStatus::several);
  ASSERT_GE(planes.supports.size(), 2U);
  EXPECT_GT(planes.supports[0].area, 0.9);
  EXPECT_GT(planes.supports[1].area, 0.9);
  for (std::size_t k = 2; k < planes.supports.size(); ++k) EXPECT_LT(planes.supports[k].area, 0.1);
}

TEST(SupportPlanes, SeenFromAboveANearTableOutweighsALargerFloor) {
  CloudBuilder builder(11);
  builder.add_rectangle({0, 0, 0.75}, {0.6, 0, 0}, {0, 0.5, 0});
  for (const double y : {-0.15, 0.0, 0.15}) builder.add_box({0.1, y, 0.75}, {0.1, 0.1, 0.1});
  builder.add_rectangle({1.5, 0, 0}, {2.2, 0, 0}, {0, 3.0, 0});
  builder.add_box({2.0, 0.5, 0}, {0.3, 0.3, 0.3});
  const Eigen::Isometry3d motion = random_motion(11);
  TablePrior known{.up = Eigen::Vector3d(motion.linear().col(2))};
  const SupportPlanes by_area = find_support_planes(builder.cloud(motion), {}, known);
  ASSERT_FALSE(by_area.supports.empty());
  EXPECT_GT(by_area.supports[0].area, 3.0);
  known.viewpoints = {motion * Eigen::Vector3d(-0.5, 0, 1.35)};
  const SupportPlanes seen = find_support_planes(builder.cloud(motion), {}, known);
  ASSERT_FALSE(seen.supports.empty());
  expect_table(seen.supports[0], motion, 0.75);
}

TEST(SupportPlanes, TellsWhichAreTilted) {
  CloudBuilder builder(13);
  add_table(builder);
  add_objects(builder);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d forward(0, -std::sin(radians(80.0)), std::cos(radians(80.0)));
  for (const Eigen::Vector3d& direction : {up, forward}) {
    TablePrior known{.up = direction};
    known.viewpoints = {{0, 0, 1.0}};
    const SupportPlanes planes = find_support_planes(builder.cloud(), {}, known);
    ASSERT_FALSE(planes.supports.empty());
    EXPECT_EQ(planes.supports[0].is_tilted, direction != up);
  }
}

TEST(SupportPlanes, TheOutlineHoldsAllPatchesThatShadowsCut) {
  CloudBuilder builder(12);
  builder.add_rectangle({-0.4, 0, 0}, {0.5, 0, 0}, {0, 0.8, 0});
  builder.add_rectangle({0.4, 0, 0}, {0.5, 0, 0}, {0, 0.8, 0});      // behind 0.3 m of shadow
  builder.add_rectangle({0.0, 0.1, 0}, {0.08, 0, 0}, {0, 0.08, 0});  // between
  builder.add_rectangle({2.0, 0, 0}, {0.3, 0, 0}, {0, 0.5, 0});      // another table
  builder.add_box({0.5, 0.2, 0}, {0.1, 0.1, 0.1});
  const TableScene scene = find_table_scene(builder.cloud());
  ASSERT_FALSE(scene.planes.supports.empty());
  EXPECT_NEAR(scene.planes.supports[0].area, 0.8, 0.1);
  EXPECT_GT(scene.objects.cloud.size(), 500U);
}

TEST(SupportPlanes, TheLidOfABoxIsNoTable) {
  CloudBuilder builder(13);
  builder.add_box({0, 0, 0}, {0.3, 0.25, 0.2});
  builder.add_box({0, 0, 0.2}, {0.05, 0.05, 0.1});
  EXPECT_EQ(find_support_planes(builder.cloud()).status, SupportStatus::none);
}

TEST(SupportPlanes, WithoutAPlaneThereIsNone) {
  EXPECT_EQ(find_support_planes({}).status, SupportStatus::none);
  EXPECT_EQ(find_support_planes(ball(20000)).status, SupportStatus::none);
  CloudBuilder builder(1);
  builder.add_box({0, 0, 0}, {0.1, 0.1, 0.1});
  const TableScene scene = find_table_scene(builder.cloud());
  EXPECT_EQ(scene.planes.status, SupportStatus::none);
  EXPECT_TRUE(scene.objects.cloud.empty());
}

TEST(SupportPlanes, PointsWithoutUsableNumbersAreLeftOut) {
  CloudBuilder builder(2);
  add_table(builder);
  add_objects(builder);
  PointCloud cloud = builder.cloud();
  for (Index i = 0; i < cloud.size(); i += 10) {
    cloud.positions(i, i % 3) = std::numeric_limits<float>::quiet_NaN();
    cloud.normals.row(i + 1).setZero();
    cloud.normals(i + 2, 0) = std::numeric_limits<float>::infinity();
  }
  const TableScene scene = find_table_scene(cloud);
  ASSERT_EQ(scene.planes.status, SupportStatus::found);
  expect_table(scene.planes.supports[0], Eigen::Isometry3d::Identity());
}

TEST(SupportPlanes, PointsWithoutNormalsAreRefused) {
  PointCloud cloud = ball(100);
  cloud.normals.resize(0, 3);
  EXPECT_THROW(find_support_planes(cloud), InputError);
}

}  // namespace
}  // namespace symscene
