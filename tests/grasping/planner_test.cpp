#include "symscene/grasping/planner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/surface_sampling.hpp"
#include "grasp_scenes.hpp"
#include "grasping/hand_collision.hpp"
#include "grasping/hand_shape.hpp"
#include "grasping/target.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using testing::box_at;
using testing::clutter;
using testing::cylinder_at;
using testing::grasps_of;
using testing::on_table;
using testing::swept_boxes;

/// How deep a point of the surface lies in the boxes. [m]
double penetration(const TriangleMesh& mesh, const Grasp& grasp,
                   const std::vector<HandBox>& boxes) {
  const PointCloud points = sample_surface(mesh, 20000);
  const Eigen::Isometry3f T_tool_world = grasp.T_world_tool.inverse().cast<float>();
  double deepest = 0.0;
  for (Index i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = T_tool_world * points.position(i);
    for (const HandBox& box : boxes)
      deepest = std::max(deepest, -static_cast<double>(box.distance(p)));
  }
  return deepest;
}

GraspScene moved(GraspScene scene, const Eigen::Isometry3d& motion) {
  scene.table = transformed(*scene.table, motion);
  for (GraspObject& object : scene.objects) {
    object.surface.mesh = transformed(object.surface.mesh, motion);
    for (ObjectAxis& axis : object.axes) {
      axis.axis.point = motion * axis.axis.point;
      axis.axis.direction = motion.linear() * axis.axis.direction;
    }
  }
  return scene;
}

/// Reflected by the plane x = 0; triangles turn so that normals point outwards.
GraspScene reflected(GraspScene scene) {
  for (GraspObject& object : scene.objects) {
    TriangleMesh& mesh = object.surface.mesh;
    mesh.vertices.col(0) *= -1.0F;
    if (mesh.normals.rows() > 0) mesh.normals.col(0) *= -1.0F;
    mesh.triangles.col(1).swap(mesh.triangles.col(2));
    for (ObjectAxis& axis : object.axes) axis.axis.point.x() *= -1.0;
  }
  return scene;
}

double best_quality(const GraspPlan& plan, int object) {
  const std::vector<Grasp> grasps = grasps_of(plan, object);
  return grasps.empty() ? 0.0 : grasps.front().quality;
}

TEST(PlanGrasps, GraspsABoxAcrossItsNarrowSide) {
  const GraspPlan plan = plan_grasps(on_table({box_at({0.05, 0.12, 0.1}, 0.0, 0.0)}), panda_hand());
  ASSERT_FALSE(plan.grasps.empty());
  for (const Grasp& grasp : plan.grasps) {
    EXPECT_NEAR(grasp.opening, 0.05, 0.002);
    EXPECT_NEAR(std::abs(grasp.T_world_tool.linear()(0, 1)), 1.0, 0.05);
  }
}

GraspOptions without_antipodal() {
  GraspOptions options;
  options.candidates.surface_points = 0;
  return options;
}

TEST(PlanGrasps, ClosesAcrossTheAxisOfACylinderAtItsDiameter) {
  const GraspPlan plan =
      plan_grasps(on_table({cylinder_at(0.03, 0.12, 0.1, 0.1)}), panda_hand(), without_antipodal());
  std::size_t across_axis = 0;
  for (const Grasp& grasp : plan.grasps) {
    if (grasp.source != GraspSource::axis_side && grasp.source != GraspSource::axis_top) continue;
    ++across_axis;
    EXPECT_NEAR(grasp.opening, 0.06, 0.002);
    EXPECT_NEAR(grasp.T_world_tool.linear()(2, 1), 0.0, 1e-6);
  }
  EXPECT_GE(across_axis, 3);
}

TEST(PlanGrasps, GraspsABowlThatIsTooWideAtItsRim) {
  const GraspPlan plan =
      plan_grasps(on_table({testing::bowl(0.08)}), panda_hand(), without_antipodal());
  const auto is_rim = [](const Grasp& grasp) { return grasp.source == GraspSource::rim; };
  ASSERT_TRUE(std::any_of(plan.grasps.begin(), plan.grasps.end(), is_rim));
  for (const Grasp& grasp : plan.grasps) EXPECT_LT(grasp.opening, 0.02);
}

TEST(PlanGrasps, GivesAMirrorPlaneAGraspThroughTheCentreOfMass) {
  GraspObject object = box_at({0.05, 0.12, 0.1}, 0.0, 0.0);
  object.planes.push_back({{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}, 0.01});
  const GraspPlan plan = plan_grasps(on_table({object}), panda_hand(), without_antipodal());
  ASSERT_FALSE(plan.grasps.empty());
  EXPECT_EQ(plan.grasps.front().source, GraspSource::mirror_plane);
  EXPECT_LT(plan.grasps.front().features.lever_arm, 0.03);
}

TEST(PlanGrasps, PenetratesNeitherTableNorObjects) {
  const GraspScene scene = clutter();
  for (const Gripper& gripper : {panda_hand(), reflex_gripper()}) {
    const std::vector<HandBox> boxes = swept_boxes(gripper);
    for (const Grasp& grasp : plan_grasps(scene, gripper).grasps) {
      for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        EXPECT_LT(penetration(scene.objects[i].surface.mesh, grasp, boxes), 0.001)
            << gripper.name << ", object " << i << " by a grasp of " << grasp.object;
      }
      const double height = height_over(*scene.table, grasp.T_world_tool, boxes);
      EXPECT_GE(height, GraspBoundOptions{}.table_clearance - 1e-6) << gripper.name;
      EXPECT_LE(grasp.features.clearance, height + 1e-6) << gripper.name;
    }
  }
}

TEST(PlanGrasps, LeavesRoomForTheHandToRetreat) {
  GraspScene scene = on_table({cylinder_at(0.03, 0.12, 0.0, 0.0)});
  const Gripper gripper = panda_hand();
  ASSERT_LT(gripper.approach_distance, gripper.retreat_distance);
  constexpr double board = 0.33;  // [m] above the way there of a hand from above
  constexpr int across = 121;
  scene.obstacles.resize(across * across, 3);
  for (int i = 0; i < across * across; ++i)
    scene.obstacles.row(i) << 0.004F * static_cast<float>(i % across - across / 2),
        0.004F * static_cast<float>(i / across - across / 2), static_cast<float>(board);
  const GraspPlan plan = plan_grasps(scene, gripper);
  ASSERT_FALSE(plan.grasps.empty());
  for (const Grasp& grasp : plan.grasps) {
    const bool is_backwards = grasp.features.tilt <= backwards_tilt;
    const Eigen::Vector3d away = is_backwards ? Eigen::Vector3d(-grasp.T_world_tool.linear().col(2))
                                              : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
    Eigen::Isometry3d retreated = grasp.T_world_tool;
    retreated.translation() += gripper.retreat_distance * away;
    const Plane below_board{-Eigen::Vector3d::UnitZ(), board};
    EXPECT_GE(height_over(below_board, retreated, hand_shape(gripper, grasp.opening, 0.0).boxes),
              0.0)
        << to_string(grasp.source);
  }
  scene.obstacles.resize(0, 3);
  EXPECT_FALSE(plan_grasps(scene, gripper).grasps.empty());
}

TEST(PlanGrasps, RefusesAnObjectThatIsTooHeavyForTheGrip) {
  const GraspScene scene = on_table({box_at({0.05, 0.1, 0.12}, 0.0, 0.0)});
  Gripper gripper = panda_hand();
  gripper.force = 1.0;  // friction holds 2 μ F = 2 N, the weight of 0.6 l is 2.9 N
  gripper.friction = 1.0;
  const GraspPlan plan = plan_grasps(scene, gripper);
  EXPECT_TRUE(plan.grasps.empty());
  EXPECT_EQ(plan.objects[0].reason, GraspRejection::weight);
  gripper.force = 2.0;
  EXPECT_FALSE(plan_grasps(scene, gripper).grasps.empty());
}

TEST(PlanGrasps, ListsGraspsFromAboveAndFromTheSide) {
  const GraspPlan plan = plan_grasps(on_table({cylinder_at(0.03, 0.2, 0.0, 0.0)}), panda_hand());
  EXPECT_EQ(plan.grasps.size(), static_cast<std::size_t>(GraspOptions{}.max_grasps));
  for (const GraspSource source : {GraspSource::axis_top, GraspSource::axis_side}) {
    EXPECT_TRUE(std::any_of(plan.grasps.begin(), plan.grasps.end(), [&](const Grasp& grasp) {
      return grasp.source == source;
    })) << to_string(source);
  }
}

TEST(GraspTarget, IsUprightTowardsTheCameraWhereNoTableIsKnown) {
  GraspScene scene = on_table({box_at({0.05, 0.1, 0.12}, 0.0, 0.0)});
  const SurfaceSamples samples = surface_samples(scene.objects[0].surface);
  const Eigen::Vector3d to_camera(0.0, 0.6, -0.8);
  EXPECT_EQ(grasp_target(scene, 0, samples, to_camera).up, Eigen::Vector3d::UnitZ());
  scene.table.reset();
  EXPECT_EQ(grasp_target(scene, 0, samples, to_camera).up, to_camera);
}

TEST(PlanGrasps, TriesBothSidesForTheSingleFingerOfThree) {
  Gripper symmetric = reflex_gripper();
  symmetric.kind = GripperKind::parallel;
  symmetric.finger_spacing = 0.0;
  const GraspScene scene = clutter();
  const GraspPlan two = plan_grasps(scene, symmetric);
  const GraspPlan three = plan_grasps(scene, reflex_gripper());
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    EXPECT_GT(2 * three.objects[i].candidates, 3 * two.objects[i].candidates) << "object " << i;
}

TEST(PlanGrasps, ClosesOnNormalsInTheFrictionCone) {
  const Gripper gripper = panda_hand();
  for (const Grasp& grasp : plan_grasps(clutter(), gripper).grasps) {
    EXPECT_GE(grasp.features.cone_margin, 0.0);
    EXPECT_LE(grasp.features.cone_margin, std::atan(gripper.friction));
    EXPECT_LT(grasp.opening, gripper.max_opening);
    EXPECT_GE(grasp.quality, 0.0);
    EXPECT_LE(grasp.quality, 1.0);
  }
}

TEST(PlanGrasps, MovesWithTheScene) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  motion.translation() = Eigen::Vector3d(0.3, -0.2, 0.9);
  const GraspPlan plan = plan_grasps(clutter(), panda_hand());
  const GraspPlan other = plan_grasps(moved(clutter(), motion), panda_hand());
  for (int object = 0; object < 5; ++object) {
    ASSERT_GT(best_quality(plan, object), 0.5) << object;
    EXPECT_NEAR(best_quality(plan, object), best_quality(other, object), 0.05) << object;
  }
}

TEST(PlanGrasps, IsReflectedWithTheScene) {
  const GraspPlan plan = plan_grasps(clutter(), panda_hand());
  const GraspPlan other = plan_grasps(reflected(clutter()), panda_hand());
  for (int object = 0; object < 5; ++object)
    EXPECT_NEAR(best_quality(plan, object), best_quality(other, object), 0.05) << object;
}

TEST(PlanGrasps, GivesTheSameForAnyNumberOfThreads) {
  const auto plan = [] { return plan_grasps(clutter(), panda_hand()); };
  const GraspPlan one = testing::with_threads(1, plan);
  const GraspPlan four = testing::with_threads(4, plan);
  ASSERT_EQ(one.grasps.size(), four.grasps.size());
  for (std::size_t i = 0; i < one.grasps.size(); ++i) {
    EXPECT_EQ(one.grasps[i].quality, four.grasps[i].quality);
    EXPECT_EQ(one.grasps[i].T_world_tool.matrix(), four.grasps[i].T_world_tool.matrix());
  }
}

TEST(PlanGrasps, CountsEveryCandidate) {
  const GraspPlan plan = plan_grasps(clutter(), panda_hand());
  ASSERT_EQ(plan.objects.size(), 5);
  for (const ObjectGraspSummary& object : plan.objects) {
    std::size_t sum = object.grasps;
    for (const std::size_t count : object.rejected) sum += count;
    EXPECT_EQ(sum, object.candidates);
    EXPECT_EQ(object.reason.has_value(), object.grasps == 0);
  }
}

TEST(PlanGrasps, TellsHowDeepARejectedGripperWouldReach) {
  const GraspScene scene = clutter();
  const GraspPlan plan = plan_grasps(scene, panda_hand());
  const std::vector<HandBox> boxes = swept_boxes(panda_hand());
  std::size_t own = 0;
  for (const RejectedGrasp& rejected : plan.rejected) {
    if (rejected.reason != GraspRejection::own_shape) continue;
    ++own;
    const auto& object = scene.objects[static_cast<std::size_t>(rejected.grasp.object)];
    const SurfaceSamples samples = surface_samples(object.surface);
    const Eigen::Isometry3f T_tool_world = rejected.grasp.T_world_tool.inverse().cast<float>();
    EXPECT_LT(rejected.value, rejected.bound);
    EXPECT_NEAR(rejected.value, least_distance(samples, T_tool_world, boxes, {0.02F, -1.0F}), 1e-6);
  }
  EXPECT_GT(own, 0);
}

TEST(PlanGrasps, OpensTheThreeFingerHandForWiderObjects) {
  const GraspScene scene = on_table({cylinder_at(0.06, 0.15, 0.0, 0.0)});
  EXPECT_TRUE(plan_grasps(scene, panda_hand()).grasps.empty());
  const GraspPlan plan = plan_grasps(scene, reflex_gripper());
  ASSERT_FALSE(plan.grasps.empty());
  EXPECT_NEAR(plan.grasps.front().opening, 0.12, 0.01);
}

}  // namespace
}  // namespace symscene
