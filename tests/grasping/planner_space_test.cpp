#include "symscene/grasping/planner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "grasp_scenes.hpp"

namespace symscene {
namespace {

using testing::box_at;
using testing::on_table;

/// 0.8 m wide around the origin, all in one state.
OccupancyGrid space(VoxelState state) {
  OccupancyGrid grid;
  grid.frame.origin = {-0.4F, -0.4F, -0.05F};
  grid.frame.resolution = 0.005F;
  grid.frame.size = {160, 160, 90};
  grid.states.assign(grid.frame.voxels(), state);
  return grid;
}

/// Makes the voxels between two values of x never seen, up to a height. [m]
void hide(OccupancyGrid& grid, float from, float to, float height) {
  for (std::size_t i = 0; i < grid.states.size(); ++i) {
    const auto along = [&](std::size_t index, int axis) {
      return grid.frame.origin[axis] + (static_cast<float>(index) + 0.5F) * grid.frame.resolution;
    };
    const float x = along(i % grid.frame.row_length(), 0);
    if (x > from && x < to && along(i / grid.frame.slice_length(), 2) < height)
      grid.states[i] = VoxelState::never_seen;
  }
}

TEST(PlanGrasps, TreatsSpaceThatWasNeverSeenAsOccupied) {
  GraspScene scene = on_table({box_at({0.05, 0.05, 0.1}, 0.0, 0.0)});
  scene.space = space(VoxelState::free);
  EXPECT_FALSE(plan_grasps(scene, panda_hand()).grasps.empty());
  // Only the face towards −x and what is before it was seen.
  hide(*scene.space, -0.02F, 1.0F, 1.0F);
  GraspOptions options;
  options.bounds.own_reach = 0.0;
  const GraspPlan plan = plan_grasps(scene, panda_hand(), options);
  EXPECT_TRUE(plan.grasps.empty());
  EXPECT_GT(plan.objects[0].rejected.at(static_cast<std::size_t>(GraspRejection::never_seen)), 0);
}

TEST(PlanGrasps, ReachesIntoTheSpaceThatTheObjectItselfHides) {
  GraspScene scene = on_table({box_at({0.05, 0.05, 0.1}, 0.0, 0.0)});
  scene.space = space(VoxelState::free);
  hide(*scene.space, 0.02F, 0.06F, 0.1F);  // behind the object
  const auto has_finger_behind = [&](const GraspOptions& options) {
    const GraspPlan plan = plan_grasps(scene, panda_hand(), options);
    return std::any_of(plan.grasps.begin(), plan.grasps.end(), [](const Grasp& grasp) {
      return std::abs(grasp.T_world_tool.linear()(0, 1)) > 0.9;
    });
  };
  EXPECT_TRUE(has_finger_behind({}));
  GraspOptions options;
  options.bounds.own_reach = 0.0;
  EXPECT_FALSE(has_finger_behind(options));
}

TEST(PlanGrasps, SaysThatAnObjectIsOutsideTheMappedSpace) {
  GraspScene scene = on_table({box_at({0.05, 0.05, 0.1}, 0.0, 0.0)});
  scene.space = space(VoxelState::never_seen);
  const GraspPlan plan = plan_grasps(scene, panda_hand());
  EXPECT_TRUE(plan.grasps.empty());
  EXPECT_EQ(plan.objects[0].reason, GraspRejection::outside_space);
}

}  // namespace
}  // namespace symscene
