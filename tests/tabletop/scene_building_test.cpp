#include "symscene/tabletop/scene_building.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "symscene/core/error.hpp"
#include "symscene/occupancy/occupancy_grid.hpp"
#include "symscene/reconstruction/reconstruction.hpp"
#include "symscene/simulation/sweep.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

/// A simulated table, reconstructed from a few small exact frames with their poses.
struct Reconstructed {
  Tabletop tabletop;
  TriangleMesh surface;
  OccupancyVolume occupancy;
  Trajectory cameras;
};

Reconstructed reconstruct(int objects) {
  SweepOptions sweep;
  sweep.tabletop.objects = std::max(objects, 1);
  sweep.tabletop.seed = 3;
  sweep.camera.frames = 10;
  sweep.camera.width = 160;
  sweep.camera.height = 120;
  sweep.camera.focal_length = 131.0;
  sweep.sensor.enabled = false;
  Reconstructed made{arrange_tabletop(sweep.tabletop), {}, OccupancyVolume(), {}};
  if (objects == 0) made.tabletop.objects.clear();
  Reconstruction reconstruction(sweep.camera.intrinsics());
  capture_sweep(made.tabletop, sweep, [&](const DepthFrame& frame, const Eigen::Isometry3d& pose) {
    reconstruction.add(frame, pose);
    made.occupancy.integrate(frame, sweep.camera.intrinsics(), pose);
    made.cameras.push_back({frame.time, pose});
  });
  made.surface = reconstruction.surface();
  return made;
}

const Reconstructed& table_of_three() {
  static const Reconstructed made = reconstruct(3);
  return made;
}

PointCloud points_of(const TriangleMesh& surface) {
  return {surface.vertices, surface.normals, surface.colors};
}

BuiltScene build(const Reconstructed& made, const std::optional<Plane>& plane = {}) {
  TablePrior known = prior_of(made.cameras);
  known.plane = plane;
  return build_scene(points_of(made.surface), made.occupancy, known);
}

void expect_objects(const BuiltScene& built, const Tabletop& tabletop) {
  ASSERT_GT(built.scene.cloud.size(), 500U);
  for (const PlacedObject& object : tabletop.objects) {
    const TriangleMesh mesh = world_mesh(object);
    const Eigen::RowVector3f low = mesh.vertices.colwise().minCoeff().array() - 0.01F;
    const Eigen::RowVector3f high = mesh.vertices.colwise().maxCoeff().array() + 0.01F;
    int on_it = 0;
    for (Index i = 0; i < built.scene.cloud.size(); ++i) {
      const Eigen::RowVector3f p = built.scene.cloud.positions.row(i);
      on_it += (p.array() > low.array()).all() && (p.array() < high.array()).all() ? 1 : 0;
    }
    EXPECT_GT(on_it, 30);
  }
  for (Index i = 0; i < built.scene.cloud.size(); ++i) {
    EXPECT_GT(tabletop.plane().signed_distance(built.scene.cloud.position(i).cast<double>()), 0.0);
  }
}

TEST(SceneBuilding, FindsTheTableAndItsObjects) {
  const BuiltScene built = build(table_of_three());
  ASSERT_TRUE(built.scene.table);
  EXPECT_LT(angle_between(built.scene.table->normal, Eigen::Vector3d::UnitZ()), radians(0.5));
  EXPECT_NEAR(built.scene.table->offset, 0.0, 0.002);
  expect_objects(built, table_of_three().tabletop);
}

TEST(SceneBuilding, UsesAGivenTable) {
  const Plane given{Eigen::Vector3d::UnitZ(), -0.001};
  const BuiltScene built = build(table_of_three(), given);
  ASSERT_TRUE(built.scene.table);
  EXPECT_EQ(built.scene.table->normal, given.normal);
  EXPECT_EQ(built.scene.table->offset, given.offset);
  expect_objects(built, table_of_three().tabletop);
}

TEST(SceneBuilding, CropsTheOccupancyAroundTheObjects) {
  const SceneBuildingOptions options;
  const BuiltScene built = build(table_of_three());
  ASSERT_TRUE(built.scene.occupancy);
  ASSERT_FALSE(built.scene.occupancy->leaves.empty());
  EXPECT_FALSE(table_of_three().occupancy.log_odds(built.region).leaves.empty());
  // The box is turned as the table is: its corners are farther out than its sides.
  const float half = 0.5F * (built.scene.cloud.positions.colwise().maxCoeff() -
                             built.scene.cloud.positions.colwise().minCoeff())
                                .norm();
  const float margin = 1.5F * (static_cast<float>(options.margin) + half);
  const Eigen::RowVector3f low = built.scene.cloud.positions.colwise().minCoeff().array() - margin;
  const Eigen::RowVector3f high = built.scene.cloud.positions.colwise().maxCoeff().array() + margin;
  const Box around{low.transpose().array() - 0.3F, high.transpose().array() + 0.3F};
  const OccupancyGrid grid = rasterize(*built.scene.occupancy, around);
  std::size_t known = 0, outside = 0, below = 0, i = 0;
  for (int z = 0; z < grid.frame.size.z(); ++z) {
    for (int y = 0; y < grid.frame.size.y(); ++y) {
      for (int x = 0; x < grid.frame.size.x(); ++x, ++i) {
        if (grid.states[i] == VoxelState::never_seen) continue;
        ++known;
        const Eigen::Vector3f p =
            grid.frame.origin +
            grid.frame.resolution * Eigen::Vector3f(static_cast<float>(x) + 0.5F,
                                                    static_cast<float>(y) + 0.5F,
                                                    static_cast<float>(z) + 0.5F);
        outside += (p.transpose().array() < low.array()).any() ||
                           (p.transpose().array() > high.array()).any()
                       ? 1
                       : 0;
        below += static_cast<double>(p.z()) < -options.table_thickness - 0.01 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(known, 10000U);
  EXPECT_EQ(outside, 0U);
  EXPECT_EQ(below, 0U);
}

TEST(SceneBuilding, OfATableWithoutObjectsIsEmptyAndATableWhereNothingIsIsRefused) {
  const Reconstructed bare = reconstruct(0);
  const BuiltScene built = build(bare);
  EXPECT_TRUE(built.scene.cloud.empty());
  EXPECT_FALSE(built.scene.occupancy);
  ASSERT_EQ(built.scene.warnings.size(), 1U);
  EXPECT_NE(built.scene.warnings[0].find("the table is bare"), std::string::npos);
  EXPECT_THROW(build(bare, Plane{Eigen::Vector3d::UnitX(), -50.0}), InputError);
}

TEST(SceneBuilding, WithoutATableHoldsAllPoints) {
  const Reconstructed& made = table_of_three();
  const BuiltScene everything =
      build_scene(points_of(made.surface), made.occupancy, {.absent = true});
  EXPECT_FALSE(everything.scene.table);
  EXPECT_TRUE(everything.scene.warnings.empty());
  EXPECT_GT(everything.scene.cloud.size(), 2 * build(made).scene.cloud.size());
  ASSERT_TRUE(everything.scene.occupancy);
  EXPECT_FALSE(everything.scene.occupancy->leaves.empty());
  // A ball is no table.
  PointCloud ball;
  ball.positions.resize(2000, 3);
  for (Index i = 0; i < 2000; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / 2000.0, angle = 2.4 * i, r = std::sqrt(1.0 - z * z);
    ball.positions.row(i) =
        Eigen::RowVector3d(r * std::cos(angle), r * std::sin(angle), z).cast<float>();
  }
  ball.normals = ball.positions;
  ball.positions *= 0.05F;
  const BuiltScene found = build_scene(ball, OccupancyVolume());
  EXPECT_FALSE(found.scene.table);
  ASSERT_EQ(found.scene.warnings.size(), 1U);
  EXPECT_NE(found.scene.warnings[0].find("no table"), std::string::npos);
  EXPECT_GT(found.scene.cloud.size(), 500U);
}

TEST(SceneBuilding, RefusesAnEmptySurfaceAndBadOptions) {
  EXPECT_THROW(build_scene({}, OccupancyVolume()), InputError);
  for (const double bad : {-0.1, std::numeric_limits<double>::quiet_NaN()}) {
    SceneBuildingOptions options;
    options.margin = bad;
    EXPECT_THROW(options.validate(), InputError);
    options = {};
    options.table_thickness = bad;
    EXPECT_THROW(options.validate(), InputError);
  }
}

TEST(SceneBuilding, LearnsFromTheCamerasWhereUpIsAndWhereTheyStood) {
  const Trajectory& cameras = table_of_three().cameras;
  const auto up = prior_of(cameras).up;
  ASSERT_TRUE(up);
  EXPECT_LT(angle_between(*up, Eigen::Vector3d::UnitZ()), radians(60.0));
  EXPECT_NEAR(up->norm(), 1.0, 1e-12);
  ASSERT_EQ(prior_of(cameras).viewpoints.size(), cameras.size());
  EXPECT_EQ(prior_of(cameras).viewpoints[0], cameras[0].T_world_camera.translation());
  EXPECT_FALSE(prior_of({}).up);
  StampedPose upright, upside_down;
  upside_down.T_world_camera.linear() =
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()).matrix();
  EXPECT_FALSE(prior_of({upright, upside_down}).up);
  EXPECT_TRUE(prior_of({upright}).up->isApprox(-Eigen::Vector3d::UnitY()));
}

TEST(SceneBuilding, IsTheSameForAnyNumberOfThreads) {
  const auto run = [] { return build(table_of_three()); };
  const BuiltScene one = testing::with_threads(1, run), two = testing::with_threads(2, run);
  EXPECT_EQ(one.scene.cloud.positions, two.scene.cloud.positions);
  EXPECT_EQ(one.scene.table->normal, two.scene.table->normal);
  EXPECT_EQ(one.scene.occupancy->leaves.size(), two.scene.occupancy->leaves.size());
}

}  // namespace
}  // namespace symscene
