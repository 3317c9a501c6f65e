#include "symscene/grasping/planner.hpp"

#include <gtest/gtest.h>

#include "simulation/shapes.hpp"
#include "symscene/grasping/gripper.hpp"

namespace symscene {
namespace {

ObjectSurface seen_all_over(const TriangleMesh& mesh) {
  return {mesh, std::vector<std::uint8_t>(static_cast<std::size_t>(mesh.triangles.rows()), 1)};
}

/// Objects on the table z = 0.
GraspScene on_table(const std::vector<TriangleMesh>& meshes) {
  GraspScene scene;
  scene.table = Plane{};
  for (const TriangleMesh& mesh : meshes) {
    scene.objects.emplace_back();
    scene.objects.back().surface = seen_all_over(mesh);
  }
  return scene;
}

TEST(PlanGrasps, GraspsABoxAcrossItsNarrowSide) {
  const GraspPlan plan = plan_grasps(on_table({make_box({0.05, 0.12, 0.1}, 0.005)}), panda_hand());
  ASSERT_FALSE(plan.grasps.empty());
  for (const Grasp& grasp : plan.grasps) {
    EXPECT_NEAR(grasp.opening, 0.05, 0.002);
    EXPECT_NEAR(std::abs(grasp.T_world_tool.linear()(0, 1)), 1.0, 0.05);
  }
}

TEST(PlanGrasps, SaysThatAnObjectIsTooWide) {
  const GraspPlan plan = plan_grasps(on_table({make_box({0.12, 0.12, 0.12}, 0.005)}), panda_hand());
  EXPECT_TRUE(plan.grasps.empty());
}

}  // namespace
}  // namespace symscene
