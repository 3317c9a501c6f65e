// Planned and rejected grasps against FCL: what is proposed is free, what is rejected for a
// collision has one.
#ifdef SYMSCENE_HAS_FCL
#include "grasping/fcl_oracle.hpp"
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "grasping/random_scenes.hpp"

namespace symscene {
namespace {

#ifdef SYMSCENE_HAS_FCL

using testing::fcl_collides;
using testing::FclGeometry;
using testing::sample_offset;
using testing::sampling_bound;

/// A scene, the plan of a gripper, and the meshes for FCL.
struct PlannedScene {
  GraspScene scene;
  Gripper gripper;
  GraspOptions options;
  GraspPlan plan;
  std::vector<FclGeometry> meshes;
  FclGeometry table = std::make_shared<fcl::Halfspaced>(Eigen::Vector3d::UnitZ(), 0.0);

  PlannedScene(std::mt19937& random, GripperKind kind)
      : scene(testing::random_scene(random)), gripper(testing::random_gripper(random, kind)) {
    options.candidates.surface_points = 20;  // fewer, for speed
    options.max_rejected = 5;
    plan = plan_grasps(scene, gripper, options);
    for (const GraspObject& object : scene.objects)
      meshes.push_back(testing::fcl_mesh(object.surface.mesh));
  }
};

/// Where a hand stands, and what it is there.
struct PlacedHand {
  Eigen::Isometry3d T_world_tool;
  std::vector<HandBox> boxes;
};

/// The open hand on its way, and the closed hand on its lift where it is lifted straight up.
std::vector<PlacedHand> approach_and_lift(const Grasp& grasp, const Gripper& gripper) {
  std::vector<PlacedHand> hands{{grasp.T_world_tool, testing::swept_boxes(gripper)}};
  if (grasp.features.tilt <= radians(60.0)) return hands;
  const std::vector<HandBox> closed = testing::hand_boxes(gripper, grasp.opening, 0.0);
  for (double height = 0.01; height <= gripper.retreat_distance; height += 0.01) {
    const Eigen::Isometry3d raised = Eigen::Translation3d(0.0, 0.0, height) * grasp.T_world_tool;
    hands.push_back({raised, closed});
  }
  return hands;
}

void expect_free(const PlannedScene& planned, const Grasp& grasp) {
  constexpr double deepest = 0.002;  // into other objects
  const double deepest_own = sampling_bound - planned.options.bounds.own_clearance;
  const std::vector<PlacedHand> hands = approach_and_lift(grasp, planned.gripper);
  EXPECT_FALSE(fcl_collides(planned.table, hands[0].T_world_tool, hands[0].boxes, 0.0));
  for (std::size_t i = 0; i < planned.meshes.size(); ++i) {
    if (static_cast<int>(i) == grasp.object) {
      EXPECT_FALSE(
          fcl_collides(planned.meshes[i], hands[0].T_world_tool, hands[0].boxes, deepest_own));
      continue;
    }
    for (const PlacedHand& hand : hands) {
      EXPECT_FALSE(fcl_collides(planned.meshes[i], hand.T_world_tool, hand.boxes, deepest))
          << "object " << i << " by a grasp of " << grasp.object;
    }
  }
}

/// Whether another object meets the hand, or the space between its fingers, if these grow by a
/// distance. [m]
bool is_near_others(const PlannedScene& planned, const Grasp& grasp, double distance) {
  std::vector<PlacedHand> hands = approach_and_lift(grasp, planned.gripper);
  hands.push_back({grasp.T_world_tool, {testing::space_between_fingers(planned.gripper)}});
  for (std::size_t i = 0; i < planned.meshes.size(); ++i) {
    if (static_cast<int>(i) == grasp.object) continue;
    for (const PlacedHand& hand : hands) {
      if (fcl_collides(planned.meshes[i], hand.T_world_tool, hand.boxes, -distance)) return true;
    }
  }
  return false;
}

bool is_near_own(const PlannedScene& planned, const Grasp& grasp, double distance) {
  return fcl_collides(planned.meshes[static_cast<std::size_t>(grasp.object)], grasp.T_world_tool,
                      testing::swept_boxes(planned.gripper), -distance);
}

TEST(PlanGraspsAgainstFcl, ProposesNoGraspThatEntersTheTableOrAnObject) {
  std::mt19937 random(5);
  std::size_t grasps = 0;
  for (const GripperKind kind : {GripperKind::parallel, GripperKind::three_finger}) {
    const PlannedScene planned(random, kind);
    for (const Grasp& grasp : planned.plan.grasps) expect_free(planned, grasp);
    grasps += planned.plan.grasps.size();
  }
  EXPECT_GT(grasps, 20);
}

TEST(PlanGraspsAgainstFcl, RejectsForACollisionOnlyWhatIsNearOne) {
  std::mt19937 random(6);
  std::array<int, grasp_rejections> checked{};
  for (const GripperKind kind : {GripperKind::parallel, GripperKind::three_finger}) {
    const PlannedScene planned(random, kind);
    for (const RejectedGrasp& rejected : planned.plan.rejected) {
      const double farthest = rejected.bound + sample_offset;
      if (rejected.reason == GraspRejection::other_object) {
        EXPECT_TRUE(is_near_others(planned, rejected.grasp, farthest));
      } else if (rejected.reason == GraspRejection::own_shape) {
        EXPECT_TRUE(is_near_own(planned, rejected.grasp, farthest));
      }
      ++checked.at(static_cast<std::size_t>(rejected.reason));
    }
  }
  EXPECT_GT(checked.at(static_cast<std::size_t>(GraspRejection::other_object)), 10);
  EXPECT_GT(checked.at(static_cast<std::size_t>(GraspRejection::own_shape)), 10);
}

#else

TEST(PlanGraspsAgainstFcl, IsSkippedWithoutFcl) { GTEST_SKIP() << "libfcl-dev is not installed"; }

#endif

}  // namespace
}  // namespace symscene
