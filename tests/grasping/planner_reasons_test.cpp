#include "symscene/grasping/planner.hpp"

#include <gtest/gtest.h>

#include "grasp_scenes.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using testing::box_at;
using testing::clutter;
using testing::grasps_of;
using testing::on_table;

TEST(PlanGrasps, SaysThatAnObjectIsTooWide) {
  const GraspPlan plan =
      plan_grasps(on_table({box_at({0.12, 0.12, 0.12}, 0.0, 0.0)}), panda_hand());
  EXPECT_TRUE(plan.grasps.empty());
  EXPECT_EQ(plan.objects[0].reason, GraspRejection::too_wide);
}

TEST(PlanGrasps, SaysWhatIsInTheWayOfAPlaceThatCanBeHeld) {
  // 20 cm long and 5 cm wide: candidates along it are too wide, those across it meet two walls.
  const GraspPlan plan =
      plan_grasps(on_table({box_at({0.2, 0.05, 0.2}, 0.0, 0.0), box_at({0.3, 0.05, 0.3}, 0.0, 0.06),
                            box_at({0.3, 0.05, 0.3}, 0.0, -0.06)}),
                  panda_hand());
  EXPECT_TRUE(grasps_of(plan, 0).empty());
  EXPECT_EQ(plan.objects[0].reason, GraspRejection::other_object);
}

TEST(PlanGrasps, SaysThatAFlatObjectLiesTooLow) {
  const GraspPlan plan =
      plan_grasps(on_table({box_at({0.05, 0.2, 0.003}, 0.0, 0.0)}), panda_hand());
  EXPECT_TRUE(plan.grasps.empty());
  EXPECT_EQ(plan.objects[0].reason, GraspRejection::table);
}

TEST(PlanGrasps, SaysThatAnObjectIsBuriedAmongOthers) {
  const GraspPlan plan = plan_grasps(
      on_table({box_at({0.05, 0.05, 0.05}, 0.0, 0.0), box_at({0.2, 0.06, 0.2}, 0.0, 0.06),
                box_at({0.2, 0.06, 0.2}, 0.0, -0.06), box_at({0.06, 0.05, 0.2}, 0.06, 0.0),
                box_at({0.06, 0.05, 0.2}, -0.06, 0.0)}),
      panda_hand());
  EXPECT_TRUE(grasps_of(plan, 0).empty());
  EXPECT_EQ(plan.objects[0].reason, GraspRejection::other_object);
}

TEST(PlanGrasps, SaysThatAnObjectHasNoSurface) {
  const GraspPlan plan = plan_grasps(on_table({GraspObject{}}), panda_hand());
  EXPECT_TRUE(plan.grasps.empty());
  EXPECT_EQ(plan.objects[0].reason, GraspRejection::no_surface);
}

/// An inside-out surface has no volume and no centre of mass.
TEST(PlanGrasps, SaysThatASurfaceHasNoVolume) {
  GraspObject object = box_at({0.05, 0.05, 0.1}, 0.0, 0.0);
  object.surface.mesh.triangles.col(1).swap(object.surface.mesh.triangles.col(2));
  const GraspPlan plan = plan_grasps(on_table({object}), panda_hand());
  EXPECT_TRUE(plan.grasps.empty());
  EXPECT_EQ(plan.objects[0].reason, GraspRejection::no_surface);
}

/// Its samples, millimetres apart, would fill the memory.
TEST(PlanGrasps, RefusesSurfacesInMillimetres) {
  const GraspScene scene = on_table({box_at({0.05, 0.05, 0.1}, 0.0, 0.0),
                                     testing::seen_all_over(make_box({50.0, 50.0, 100.0}, 10.0))});
  EXPECT_THROW(plan_grasps(scene, panda_hand()), InputError);
}

TEST(PlanGrasps, TakesSurfacesOfFurniture) {
  const GraspScene scene = on_table({testing::seen_all_over(make_box({0.8, 0.4, 0.4}, 0.3)),
                                     box_at({0.05, 0.05, 0.1}, 1.0, 0.0)});
  const GraspPlan plan = plan_grasps(scene, panda_hand());
  EXPECT_EQ(plan.objects[0].reason, GraspRejection::too_wide);
  EXPECT_FALSE(grasps_of(plan, 1).empty());
}

TEST(PlanGrasps, OfNoObjectIsEmpty) {
  const GraspPlan plan = plan_grasps(GraspScene{}, panda_hand());
  EXPECT_TRUE(plan.grasps.empty());
  EXPECT_TRUE(plan.objects.empty());
}

/// The table says so: nothing can be approached from below it.
TEST(PlanGrasps, FindsNoGraspBelowTheTable) {
  GraspScene scene = clutter();
  scene.table = transformed(Plane{}, Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.5)));
  const GraspPlan plan = plan_grasps(scene, panda_hand());
  EXPECT_TRUE(plan.grasps.empty());
  for (const ObjectGraspSummary& object : plan.objects)
    EXPECT_EQ(object.reason, GraspRejection::table);
}

TEST(PlanGrasps, RefusesAGripperThatContradictsItself) {
  Gripper gripper = panda_hand();
  gripper.min_opening = 0.1;
  EXPECT_THROW(plan_grasps(clutter(), gripper), InputError);
}

}  // namespace
}  // namespace symscene
