#include "motion/free_columns.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "small_arm.hpp"
#include "symscene/motion/motion_obstacles.hpp"

namespace symscene {
namespace {

/// Space over the table, from x = 0.2 to 0.7 m, y = ±0.25 m, up to 0.3 m; all of it free.
OccupancyGrid free_space() {
  OccupancyGrid grid;
  grid.frame = {{0.2F, -0.25F, -0.02F}, 0.01F, {50, 50, 32}};
  grid.states.assign(grid.frame.voxels(), VoxelState::free);
  return grid;
}

void hide(OccupancyGrid& grid, const Eigen::AlignedBox3f& box) {
  for (std::size_t i = 0; i < grid.states.size(); ++i) {
    const Eigen::Vector3f voxel(
        static_cast<float>(i % grid.frame.row_length()),
        static_cast<float>(i % grid.frame.slice_length() / grid.frame.row_length()),
        static_cast<float>(i / grid.frame.slice_length()));
    const Eigen::Vector3f centre =
        grid.frame.origin.array() + grid.frame.resolution * (voxel.array() + 0.5F);
    if (box.contains(centre)) grid.states[i] = VoxelState::never_seen;
  }
}

/// A box of 10 cm height at x = 0.4 m, seen from the side of the origin.
GraspScene scene_in(const OccupancyGrid& space) {
  GraspScene scene;
  scene.table = Plane{};
  scene.objects = {testing::box_of_points({0.04, 0.04, 0.1}, {0.4, 0.0, 0.05})};
  scene.space = space;
  return scene;
}

bool is_blocked(const GraspScene& scene, const Eigen::Vector3d& point) {
  const auto met = MotionObstacles(scene).nearest(Capsule{point, point, 0.009}, {});
  return met && met->distance < 0.0 && met->kind == ObstacleKind::never_seen;
}

TEST(FreeColumns, HideNothingAboveFreeSpaceOnTablesOfAnyTilt) {
  Random random(11);
  for (int i = 0; i < 50; ++i) {
    Plane table;
    table.normal = Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), 1.0).normalized();
    table.offset = random.uniform(-0.2, 0.2);
    const VoxelFrame frame{{-1.0F, -1.0F, -1.0F}, 0.01F, {200, 200, 200}};
    FreeColumns columns(table, frame, 0.01F, 0.4);
    const Eigen::Vector3d near(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0.0);
    const Eigen::Vector3d foot = near - table.signed_distance(near) * table.normal;
    const auto at = [&](double height) {
      return Eigen::Vector3f((foot + height * table.normal).cast<float>());
    };
    EXPECT_TRUE(columns.may_hide(at(0.3)));
    EXPECT_FALSE(columns.may_hide(at(0.41)));
    columns.add_free(at(0.002));  // cut by the table
    EXPECT_TRUE(columns.may_hide(at(0.3)));
    columns.add_free(at(0.1));
    EXPECT_TRUE(columns.may_hide(at(0.09)));
    EXPECT_FALSE(columns.may_hide(at(0.11)));
    EXPECT_FALSE(columns.may_hide(at(0.3)));
  }
}

TEST(FreeColumns, LeaveShadowsAsObstacles) {
  OccupancyGrid space = free_space();
  hide(space, {Eigen::Vector3f(0.5F, -0.05F, -1.0F), Eigen::Vector3f(0.6F, 0.05F, 0.06F)});
  hide(space, {Eigen::Vector3f(0.5F, -0.2F, 0.05F), Eigen::Vector3f(0.6F, -0.1F, 0.09F)});
  const GraspScene scene = scene_in(space);
  EXPECT_TRUE(is_blocked(scene, {0.55, 0.0, 0.04}));
  EXPECT_FALSE(is_blocked(scene, {0.55, 0.0, 0.09}));
  EXPECT_FALSE(is_blocked(scene, {0.55, -0.15, 0.07})) << "nothing carries it";
}

TEST(FreeColumns, EndAtTheHighestSeenSurface) {
  OccupancyGrid space = free_space();
  hide(space, {Eigen::Vector3f(0.5F, -1.0F, -1.0F), Eigen::Vector3f(1.0F, 1.0F, 1.0F)});
  GraspScene scene = scene_in(space);
  EXPECT_TRUE(is_blocked(scene, {0.6, 0.1, 0.08}));
  EXPECT_FALSE(is_blocked(scene, {0.6, 0.1, 0.13}));
  scene.objects.push_back(testing::box_of_points({0.04, 0.04, 0.2}, {0.4, 0.1, 0.1}));
  EXPECT_TRUE(is_blocked(scene, {0.6, 0.1, 0.13}));
  scene.table.reset();
  EXPECT_TRUE(is_blocked(scene, {0.6, 0.1, 0.25})) << "nothing is known of what could stand there";
}

}  // namespace
}  // namespace symscene
