#include "tabletop/table_search.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>

#include "core/random.hpp"
#include "core/surface_sampling.hpp"
#include "core/voxel_sampling.hpp"
#include "simulation/frame_fusion.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/error.hpp"
#include "symscene/io/cloud.hpp"
#include "symscene/io/table_plane.hpp"
#include "symscene/simulation/simulation.hpp"
#include "tabletop/support_plane.hpp"

namespace symscene {
namespace {

/// Sanitizers make each seed thirty times slower.
#ifdef SYMSCENE_SANITIZED
constexpr std::uint64_t seeds = 1;
#else
constexpr std::uint64_t seeds = 4;
#endif

/// Builds a cloud from noisy surfaces.
class CloudBuilder {
 public:
  explicit CloudBuilder(std::uint64_t seed, double noise = 0.0015) : random_(seed), noise_(noise) {}

  /// A rectangle of points 4 mm apart, its middle at `middle`.
  void add_rectangle(const Eigen::Vector3d& middle, const Eigen::Vector3d& along,
                     const Eigen::Vector3d& across) {
    const Eigen::Vector3d normal = along.cross(across).normalized();
    const auto count = static_cast<int>(along.norm() * across.norm() / 16e-6);
    for (int i = 0; i < count; ++i) {
      add(middle + random_.uniform(-0.5, 0.5) * along + random_.uniform(-0.5, 0.5) * across,
          normal);
    }
  }

  void add_box(const Eigen::Vector3d& foot, const Eigen::Vector3d& size) {
    const PointCloud box = sample_surface(make_box(size, 0.02), 6000);
    const Eigen::Vector3d lift = foot + Eigen::Vector3d(0, 0, 0.5 * size.z());
    const Eigen::Vector3d center =
        0.5 * (box.positions.colwise().minCoeff() + box.positions.colwise().maxCoeff())
                  .transpose()
                  .cast<double>();
    for (Index i = 0; i < box.size(); ++i) {
      if (box.normal(i).z() < -0.5F) continue;
      add(box.position(i).cast<double>() - center + lift, box.normal(i).cast<double>());
    }
  }

  /// The shift of points along z, as by drift.
  std::function<double(const Eigen::Vector3d&)> bend = [](const Eigen::Vector3d&) { return 0.0; };

  PointCloud cloud(const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity()) const {
    PointCloud result;
    const auto count = static_cast<Eigen::Index>(positions_.size());
    result.positions.resize(count, 3);
    result.normals.resize(count, 3);
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      result.positions.row(row) = (motion * positions_[i]).cast<float>().transpose();
      result.normals.row(row) = (motion.linear() * normals_[i]).cast<float>().transpose();
    }
    return result;
  }

 private:
  void add(const Eigen::Vector3d& position, const Eigen::Vector3d& normal) {
    positions_.push_back(position + noise_ * random_.normal() * normal +
                         Eigen::Vector3d(0, 0, bend(position)));
    const Eigen::Vector3d tilt(random_.normal(), random_.normal(), random_.normal());
    normals_.push_back((normal + 0.07 * tilt).normalized());
  }

  Random random_;
  double noise_;
  std::vector<Eigen::Vector3d> positions_;
  std::vector<Eigen::Vector3d> normals_;
};

/// A table of 1.2 m by 0.8 m at z = 0.
void add_table(CloudBuilder& builder, const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  builder.add_rectangle(middle, {1.2, 0, 0}, {0, 0.8, 0});
}

void add_objects(CloudBuilder& builder, const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  builder.add_box(middle + Eigen::Vector3d(0.2, 0.1, 0), {0.06, 0.16, 0.21});
  builder.add_box(middle + Eigen::Vector3d(-0.2, -0.1, 0), {0.1, 0.1, 0.05});
  builder.add_box(middle + Eigen::Vector3d(-0.3, 0.2, 0), {0.2, 0.15, 0.12});
}

std::filesystem::path data_folder() {
  const char* variable = std::getenv("SYMSCENE_DATA");
  return variable != nullptr ? variable : SYMSCENE_SOURCE_DIR "/../shared/data";
}

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

/// How many of the points are lower than `height` over z = 0.
Index below(const PointCloud& cloud, float height) {
  Index count = 0;
  for (Index i = 0; i < cloud.size(); ++i) count += cloud.position(i).z() < height ? 1 : 0;
  return count;
}

TEST(TableScene, HoldsTheObjectsWithoutTheTable) {
  CloudBuilder builder(4);
  add_table(builder);
  add_objects(builder);
  const TableScene scene = find_table_scene(builder.cloud());
  ASSERT_EQ(scene.planes.status, SupportStatus::found);
  EXPECT_EQ(below(scene.objects.cloud, 0.003F), 0U);
  CloudBuilder alone(4);
  add_objects(alone);
  const PointCloud objects = voxel_downsample(alone.cloud(), 0.005);
  EXPECT_GT(scene.objects.cloud.size(), 0.9 * objects.size());
  EXPECT_LT(scene.objects.cloud.size(), 1.05 * objects.size());
}

TEST(TableScene, AThinObjectOnABentTableIsKept) {
  CloudBuilder builder(5, 0.001);
  builder.bend = [](const Eigen::Vector3d& p) {
    return 0.02 * p.x() * p.x() - 0.01 * p.y() * p.x();
  };
  add_table(builder);
  add_objects(builder);
  builder.add_box({0.0, 0.25, 0}, {0.15, 0.1, 0.009});
  const PointCloud cloud = builder.cloud();
  const auto thin_points = [&](const TableScene& scene) {
    Index count = 0;
    for (Index i = 0; i < scene.objects.cloud.size(); ++i) {
      const Eigen::Vector3f p = scene.objects.cloud.position(i);
      count += std::abs(p.x()) < 0.075F && std::abs(p.y() - 0.25F) < 0.05F ? 1 : 0;
    }
    return count;
  };
  const TableScene scene = find_table_scene(cloud);
  ASSERT_EQ(scene.planes.status, SupportStatus::found);
  EXPECT_GT(thin_points(scene), 400U);
  EXPECT_LT(scene.objects.clearance, 0.007);
  TableSceneOptions flat;
  flat.crop.follow_bend = false;
  EXPECT_GT(find_table_scene(cloud, flat).objects.clearance, scene.objects.clearance);
}

/// As far from a camera, where noise makes points of the table stand higher than small objects.
TEST(TableScene, PointsOfATableThatIsRoughSomewhereAreNoObjectsThere) {
  CloudBuilder builder(8, 0.001);
  Random random(9);
  builder.bend = [&](const Eigen::Vector3d& p) {
    return p.x() > 0.3 ? 0.012 * random.normal() : 0.0;
  };
  add_table(builder);
  builder.add_box({-0.2, -0.1, 0}, {0.1, 0.1, 0.03});
  const auto count_beyond = [&](const TableScene& scene, float x) {
    return (scene.objects.cloud.positions.col(0).array() > x).count();
  };
  TableSceneOptions options;
  options.crop.link = 0.03;  // so that scattered points are fragments too
  options.crop.min_fragment = 10;
  options.crop.rough_clearance_sigmas = 3.0;
  const PointCloud cloud = builder.cloud();
  const TableScene scene = find_table_scene(cloud, options);
  ASSERT_EQ(scene.planes.status, SupportStatus::found);
  EXPECT_GT(scene.objects.cloud.size(), 500U) << "the box is kept where the table is smooth";
  const auto rough = count_beyond(scene, 0.3F);
  options.crop.rough_clearance_sigmas = 0.0;
  EXPECT_LT(3 * rough, count_beyond(find_table_scene(cloud, options), 0.3F));
}

TEST(TableScene, StrayFragmentsAreDropped) {
  CloudBuilder builder(6);
  add_table(builder);
  add_objects(builder);
  builder.add_rectangle({0.4, -0.3, 0.2}, {0.02, 0, 0}, {0, 0.02, 0});
  const TableScene scene = find_table_scene(builder.cloud());
  EXPECT_GE(scene.objects.dropped_fragments, 1U);
  for (Index i = 0; i < scene.objects.cloud.size(); ++i) {
    const Eigen::Vector3f p = scene.objects.cloud.position(i);
    EXPECT_GT((p - Eigen::Vector3f(0.4F, -0.3F, 0.2F)).norm(), 0.05F);
  }
}

TEST(TableScene, ObjectsOverTheBorderAreKeptAndObjectsBesideTheTableAreNot) {
  CloudBuilder builder(7);
  add_table(builder);
  add_objects(builder);
  builder.add_box({0.58, -0.2, 0}, {0.1, 0.1, 0.1});     // 3 cm over the border at 0.6 m
  builder.add_box({0.0, -0.47, -0.3}, {0.3, 0.1, 0.5});  // a chair, from 2 cm off
  const TableScene scene = find_table_scene(builder.cloud());
  ASSERT_EQ(scene.planes.status, SupportStatus::found);
  EXPECT_GT(scene.objects.cloud.positions.col(0).maxCoeff(), 0.62F);
  EXPECT_GT(scene.objects.cloud.positions.col(1).minCoeff(), -0.41F);
}

TEST(TableScene, AGivenPlaneIsUsed) {
  CloudBuilder builder(8);
  add_table(builder);
  add_objects(builder);
  add_table(builder, {2.0, 0, 0.3});
  builder.add_box({2.0, 0, 0.3}, {0.1, 0.1, 0.1});
  const TableScene scene =
      find_table_scene(builder.cloud(), {}, {.plane = Plane{{0, 0, 2.0}, -0.6}});
  ASSERT_EQ(scene.planes.status, SupportStatus::found);
  EXPECT_EQ(scene.planes.supports[0].plane.offset, -0.3);
  EXPECT_GT(scene.objects.cloud.size(), 500U);
  EXPECT_GT(scene.objects.cloud.positions.col(0).minCoeff(), 1.9F);
  const TablePrior aside{.plane = Plane{{0, 0, 1.0}, 5.0}},
      degenerate{.plane = Plane{{0, 0, 0}, 1.0}};
  EXPECT_EQ(find_table_scene(builder.cloud(), {}, aside).planes.status, SupportStatus::none);
  EXPECT_THROW(find_table_scene(builder.cloud(), {}, degenerate), InputError);
}

TEST(TableScene, TheSameInputGivesTheSameBytes) {
  CloudBuilder builder(9);
  add_table(builder);
  add_objects(builder);
  const PointCloud cloud = builder.cloud();
  const TableScene a = find_table_scene(cloud);
  const TableScene b = find_table_scene(cloud);
  EXPECT_EQ(a.planes.supports[0].plane.offset, b.planes.supports[0].plane.offset);
  EXPECT_EQ(a.objects.cloud.positions, b.objects.cloud.positions);
}

TEST(TableScene, FindsTableAndObjectsInASimulatedScan) {
  SimulationOptions options;
  options.tabletop.seed = 1001;
  options.tabletop.random_frame = true;
  options.camera.frames = 10;
  options.camera.width = 320;
  options.camera.height = 240;
  options.camera.focal_length = 262.0;
#ifdef SYMSCENE_SANITIZED
  options.camera.frames = 5;
#endif
  const Tabletop tabletop = arrange_tabletop(options.tabletop);
  const auto frames = capture_frames(tabletop, options);
  OrientedBox region;
  region.T_world_box = tabletop.T_world_table;
  region.min << -0.6, -0.6, -0.05;
  region.max << 0.6, 0.6, 0.5;
  const FusedCloud fused = fuse_cloud(frames, options.camera.intrinsics(), region, options.cloud);
  const TableScene scene = find_table_scene(fused.cloud);
  ASSERT_EQ(scene.planes.status, SupportStatus::found);
  const Plane truth = tabletop.plane();
  const Plane& found = scene.planes.supports[0].plane;
  EXPECT_LT(degrees(angle_between(found.normal, truth.normal)), 0.2);
  EXPECT_LT(std::abs(found.signed_distance(tabletop.T_world_table.translation())), 0.0015);
  PointIndices on_objects;
  for (Index i = 0; i < fused.cloud.size(); ++i) {
    const bool high = truth.signed_distance(fused.cloud.position(i).cast<double>()) > 0.008;
    if (fused.objects[i] < tabletop.objects.size() && high) on_objects.push_back(i);
  }
  const Index expected = voxel_downsample(select(fused.cloud, on_objects), 0.005).size();
#ifndef SYMSCENE_SANITIZED  // five small frames show the objects in shreds
  EXPECT_GT(scene.objects.cloud.size(), 0.93 * expected);
#endif
  EXPECT_LT(scene.objects.cloud.size(), 1.15 * expected);
}

TEST(TableScene, RealObjectsOnTheirTableAreKept) {
  const std::filesystem::path sample = data_folder() / "ctd_sample";
  if (!std::filesystem::exists(sample)) GTEST_SKIP() << "skipped: no data";
  const PointCloud objects = read_cloud(sample / "cloud.ply");
  const Plane table = read_table_plane(sample / "table_plane.txt");
  // The sample has no points of the table: noisy ones are laid under the objects.
  const Eigen::Matrix<double, 3, 2> basis = orthonormal_complement(table.normal);
  const Eigen::Vector3d center = centroid(objects.positions);
  CloudBuilder builder(1);
  builder.add_rectangle(center - table.signed_distance(center) * table.normal, 1.2 * basis.col(0),
                        1.2 * basis.col(1));
  const PointCloud ground = builder.cloud();
  PointCloud cloud;
  cloud.positions.resize(objects.size() + ground.size(), 3);
  cloud.normals.resize(cloud.positions.rows(), 3);
  cloud.positions << objects.positions, ground.positions;
  cloud.normals << objects.normals, ground.normals;
  const TableScene scene = find_table_scene(cloud);
  ASSERT_EQ(scene.planes.status, SupportStatus::found);
  EXPECT_LT(degrees(angle_between(scene.planes.supports[0].plane.normal, table.normal)), 0.2);
  const Index thinned = voxel_downsample(objects, 0.005).size();
  EXPECT_GT(scene.objects.cloud.size(), 0.95 * thinned);
  EXPECT_LT(scene.objects.cloud.size(), 1.02 * thinned);
}

TEST(TableSceneOptions, InvalidValuesAreRefused) {
  TableSceneOptions options;
  options.plane.normal_angle = 2.0;
  EXPECT_THROW(options.validate(), InputError);
  options = {};
  options.crop.max_clearance = 0.001;
  EXPECT_THROW(options.validate(), InputError);
  options = {};
  options.plane.max_height = 0.5 * options.plane.inlier_distance;
  EXPECT_THROW(options.plane.validate(), InputError);
  options = {};
  options.crop.max_clearance = options.plane.max_height;
  EXPECT_THROW(options.validate(), InputError);
}

}  // namespace
}  // namespace symscene
