#include "symscene/motion/arm_collision.hpp"

#include <gtest/gtest.h>

#include "motion/arm_bodies.hpp"
#include "motion/segment_distance.hpp"
#include "small_arm.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/geometry.hpp"

#ifdef SYMSCENE_HAS_FCL
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/distance.h>
#endif

namespace symscene {
namespace {

using testing::box_of_points;
using testing::random_positions;
using testing::small_arm;
using testing::small_gripper;

Eigen::Vector3d random_point(Random& random, double reach) {
  return {random.uniform(-reach, reach), random.uniform(-reach, reach),
          random.uniform(-reach, reach)};
}

Capsule random_capsule(Random& random) {
  const Eigen::Vector3d begin = random_point(random, 1.0);
  Eigen::Vector3d end = begin + random_point(random, 0.5);
  if (random.chance(0.1)) end = begin;
  return {begin, end, random.uniform(0.01, 0.2)};
}

GraspScene scene_with(const std::vector<GraspObject>& objects) {
  GraspScene scene;
  scene.table = Plane{};
  scene.objects = objects;
  return scene;
}

TEST(CapsuleDistance, IsThatOfTheNearestPoints) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Capsule a = random_capsule(random);
    Capsule b = random_capsule(random);
    if (i % 5 == 0) b.end = b.begin + (a.end - a.begin);  // parallel
    double least = 1e9;
    for (double s = 0.0; s <= 1.0; s += 0.005) {
      const Eigen::Vector3d point = a.begin + s * (a.end - a.begin);
      least = std::min(least, segment_distance(point, b.begin, b.end));
    }
    const double distance = capsule_distance(a, b);
    EXPECT_LE(distance, least - a.radius - b.radius + 1e-12);
    EXPECT_GE(distance, least - a.radius - b.radius - 0.005);
    EXPECT_NEAR(distance, capsule_distance(b, a), 1e-12);
  }
}

#ifdef SYMSCENE_HAS_FCL
TEST(CapsuleDistance, EqualsThatOfFcl) {
  const auto fcl_object = [](const Capsule& capsule) {
    const Eigen::Vector3d along = capsule.end - capsule.begin;
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    pose.linear() = symscene::shortest_rotation(Eigen::Vector3d::UnitZ(), along);
    pose.translation() = 0.5 * (capsule.begin + capsule.end);
    return fcl::CollisionObjectd(std::make_shared<fcl::Capsuled>(capsule.radius, along.norm()),
                                 pose);
  };
  Random random(4);
  int apart = 0;
  for (int i = 0; i < 500; ++i) {
    const Capsule a = random_capsule(random);
    const Capsule b = random_capsule(random);
    if ((a.end - a.begin).norm() == 0.0 || (b.end - b.begin).norm() == 0.0) continue;
    const double ours = capsule_distance(a, b);
    if (ours <= 0.0) continue;  // FCL gives no depth
    const fcl::CollisionObjectd first = fcl_object(a);
    const fcl::CollisionObjectd second = fcl_object(b);
    fcl::DistanceRequestd request;
    request.distance_tolerance = 1e-9;
    fcl::DistanceResultd result;
    fcl::distance(&first, &second, request, result);
    EXPECT_NEAR(ours, result.min_distance, 1e-6);
    ++apart;
  }
  EXPECT_GT(apart, 100);
}
#endif

TEST(MotionObstacles, BoundTheDistanceToPointsFromBelow) {
  const GraspObject box = box_of_points({0.1, 0.2, 0.15}, {0.4, 0.0, 0.1});
  const MotionObstacles obstacles(scene_with({box}));
  Random random(5);
  int near = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d point = Eigen::Vector3d(0.4, 0.0, 0.1) + random_point(random, 0.3);
    double least = 1e9;
    for (Index k = 0; k < box.observed.size(); ++k)
      least = std::min(least, (box.observed.position(k).cast<double>() - point).norm());
    EXPECT_LE(obstacles.bound_at(point), least);
    const Capsule ball{point, point, 0.01};
    const auto found = obstacles.nearest(ball, {});
    // Observed points 5 mm apart are thinned to one in 4 mm and stand for balls of 3 mm.
    if (least < 0.04) {
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->distance, least - 0.01 - 0.003, 0.004);
      EXPECT_EQ(found->object, 0);
      ++near;
    } else if (least > 0.06) {
      EXPECT_FALSE(found);
    }
    EXPECT_FALSE(obstacles.nearest(ball, {.surface_of = 0}));
  }
  EXPECT_GT(near, 20);
}

TEST(GreatestMotion, IsNotExceededByAnyPoint) {
  const Robot robot = small_arm();
  Random random(6);
  const Eigen::Vector3d point(0.02, -0.03, 0.1);
  for (std::size_t link = 1; link < robot.model.links.size(); ++link) {
    const Eigen::VectorXd bound =
        greatest_motion(robot.model, robot.arms[0].arm, link, point.norm());
    for (int i = 0; i < 50; ++i) {
      const Eigen::VectorXd a = random_positions(robot, random);
      const Eigen::VectorXd b = a + 0.1 * Eigen::VectorXd::Random(6);
      const double moved =
          (link_poses(robot.model, a)[link] * point - link_poses(robot.model, b)[link] * point)
              .norm();
      EXPECT_LE(moved, bound.dot((b - a).cwiseAbs()) + 1e-12);
    }
  }
}

TEST(ArmCollision, SaysWhatMeetsWhat) {
  const Robot robot = small_arm();
  const Gripper gripper = small_gripper();
  const MotionObstacles none(scene_with({}));
  const ArmCollision free(robot, robot.arms[0], &gripper, 0.08, none, robot.home);
  EXPECT_FALSE(free.contact(robot.home));
  // Stretched out over the side and below the table.
  Eigen::VectorXd low = Eigen::VectorXd::Zero(6);
  low[1] = 2.2;
  const auto table = free.contact(low);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->other.kind, ObstacleKind::table);
  EXPECT_NE(describe(*table).find("the table"), std::string::npos);
  // The hand at home, from where a box is.
  const Eigen::Isometry3d T_world_tip = link_poses(robot.model, robot.home).back();
  const MotionObstacles box(scene_with(
      {box_of_points({0.06, 0.06, 0.06}, T_world_tip * Eigen::Vector3d(0.0, 0.05, 0.15))}));
  const ArmCollision blocked(robot, robot.arms[0], &gripper, 0.08, box, robot.home);
  const auto hand = blocked.contact(robot.home);
  ASSERT_TRUE(hand);
  EXPECT_EQ(hand->part, "gripper");
  EXPECT_EQ(hand->other.kind, ObstacleKind::object);
  EXPECT_LT(hand->other.distance, 0.0);
  // Folded onto itself.
  Eigen::VectorXd folded = Eigen::VectorXd::Zero(6);
  folded[2] = 2.9;
  const auto self = free.contact(folded);
  ASSERT_TRUE(self);
  EXPECT_EQ(self->other.kind, ObstacleKind::robot);
}

/// A vertical sheet of points, 1 mm thin, that the arm sweeps through.
TEST(ArmCollision, PassesOverNoThinObstacle) {
  const Robot robot = small_arm();
  const MotionObstacles sheet(scene_with({box_of_points({0.2, 0.001, 0.2}, {0.5, 0.0, 0.5})}));
  const ArmCollision arm(robot, robot.arms[0], nullptr, 0.0, sheet, robot.home);
  Eigen::VectorXd from = Eigen::VectorXd::Zero(6);
  from << -1.5, 0.9, 1.0, 0.0, 0.0, 0.0;
  Eigen::VectorXd to = from;
  to[0] = 1.5;
  EXPECT_FALSE(arm.contact(from));
  EXPECT_FALSE(arm.contact(to));
  RobotContact met;
  EXPECT_FALSE(arm.is_free(from, to, {}, &met));
  EXPECT_EQ(met.other.kind, ObstacleKind::object);
  EXPECT_TRUE(arm.is_free(from, to, {.surface_of = 0}));
}

TEST(ArmCollision, FindsMotionsFreeOnlyIfAllTheirConfigurationsAre) {
  const Robot robot = small_arm();
  const Gripper gripper = small_gripper();
  const MotionObstacles obstacles(scene_with({box_of_points({0.1, 0.1, 0.4}, {0.4, 0.1, 0.2}),
                                              box_of_points({0.2, 0.02, 0.3}, {0.3, -0.3, 0.4})}));
  const ArmCollision arm(robot, robot.arms[0], &gripper, 0.08, obstacles, robot.home);
  Random random(7);
  int free = 0;
  for (int i = 0; i < 60; ++i) {
    const Eigen::VectorXd a = random_positions(robot, random);
    const Eigen::VectorXd b = a + 0.3 * (random_positions(robot, random) - a);
    if (!arm.is_free(a, b)) continue;
    ++free;
    for (double share = 0.0; share <= 1.0; share += 0.01) {
      const auto met = arm.contact(a + share * (b - a));
      // A motion may come nearer than the bound, by half of it, between its steps.
      EXPECT_TRUE(!met || met->other.distance > 0.5 * met->bound - 1e-9) << i;
    }
  }
  EXPECT_GT(free, 3);
}

TEST(ArmCollision, AnUprightLinkStandsInAMeasuredTable) {
  const Robot robot = small_arm();
  for (const double degrees : {0.0, 0.1, 1.0, 3.0}) {
    GraspScene scene = scene_with({});
    scene.table = Plane{
        Eigen::AngleAxisd(radians(degrees), Eigen::Vector3d::UnitX()) * Eigen::Vector3d::UnitZ(),
        0.002};
    const MotionObstacles obstacles(scene);
    const ArmCollision arm(robot, robot.arms[0], nullptr, 0.0, obstacles, robot.home);
    EXPECT_FALSE(arm.contact(robot.home)) << degrees << " degrees";
  }
}

TEST(ArmCollision, CarriesWhatItHolds) {
  const Robot robot = small_arm();
  const Gripper gripper = small_gripper();
  const MotionObstacles none(scene_with({}));
  ArmCollision arm(robot, robot.arms[0], &gripper, 0.02, none, robot.home);
  const Eigen::Isometry3d T_world_tip = link_poses(robot.model, robot.home).back();
  EXPECT_FALSE(arm.contact(robot.home));
  // A long stick that reaches down below the table.
  const Eigen::Isometry3d T_tool_world = (T_world_tip * gripper.T_wrist_tool).inverse();
  const Eigen::Vector3d tool = T_world_tip * gripper.T_wrist_tool.translation();
  std::vector<Eigen::Vector3f> stick;
  for (double z = -0.05; z < tool.z(); z += 0.01)
    stick.emplace_back((T_tool_world * Eigen::Vector3d(tool.x(), tool.y(), z)).cast<float>());
  arm.hold(stick);
  const auto met = arm.contact(robot.home);
  ASSERT_TRUE(met);
  EXPECT_EQ(met->part, "held object");
  EXPECT_NEAR(met->other.distance, -0.05, 1e-6);
}

TEST(ArmCollision, WhatIsLiftedMayKeepItsContactsButMeetNoOther) {
  const Robot robot = small_arm();
  const Eigen::Isometry3d T_world_tip = link_poses(robot.model, robot.home).back();
  const Eigen::Vector3d side = T_world_tip.translation() + Eigen::Vector3d(0.0, 0.15, 0.0);
  // A point is held beside a box: the gap before the lift, and later.
  const auto is_met = [&](double gap_before, double gap) {
    const GraspScene scene =
        scene_with({box_of_points({0.04, 0.04, 0.04}, side + Eigen::Vector3d(0.0, 0.02, 0.0))});
    const MotionObstacles obstacles(scene);
    ArmCollision arm(robot, robot.arms[0], nullptr, 0.02, obstacles, robot.home);
    const auto hold = [&](double y) {
      const Eigen::Vector3d point = side - Eigen::Vector3d(0.0, y, 0.0);
      arm.hold({(T_world_tip.inverse() * point).cast<float>()});
    };
    hold(gap_before);
    arm.allow_contacts_at(robot.home, {});
    hold(gap);
    return arm.contact(robot.home).has_value();
  };
  // Surfaces are balls of 3 mm.
  EXPECT_FALSE(is_met(0.003, 0.003)) << "touched from the start";
  EXPECT_TRUE(is_met(0.003, 0.0)) << "pushed into its neighbour";
  EXPECT_FALSE(is_met(0.02, 0.006));
  EXPECT_TRUE(is_met(0.02, 0.003)) << "was away from it";
}

TEST(ArmCollision, OfNeverSeenSpaceSparesTheTargetAndTheStart) {
  GraspScene scene = scene_with({box_of_points({0.06, 0.06, 0.1}, {0.5, 0.0, 0.05})});
  OccupancyGrid space;
  space.frame = {{0.3F, -0.2F, 0.0F}, 0.01F, {40, 40, 30}};
  space.states.assign(space.frame.voxels(), VoxelState::never_seen);
  scene.space = space;
  const MotionObstacles obstacles(scene);
  const Eigen::Vector3d beside(0.5, 0.06, 0.08);
  const Eigen::Vector3d away(0.6, 0.15, 0.09);
  const auto at = [&](const Eigen::Vector3d& point, const IgnoredObstacles& ignored) {
    const auto met = obstacles.nearest(Capsule{point, point, 0.009}, ignored);
    return met && met->kind == ObstacleKind::never_seen && met->distance < 0.0;
  };
  EXPECT_TRUE(at(beside, {}));
  EXPECT_FALSE(at(beside, {.never_seen_at = 0}));
  EXPECT_TRUE(at(away, {.never_seen_at = 0}));
  const MotionObstacles with_robot(scene, {Capsule{away, away, 0.05}});
  EXPECT_FALSE(with_robot.nearest(Capsule{away, away, 0.005}, {}));
  MotionObstacleOptions free;
  free.never_seen = false;
  EXPECT_FALSE(MotionObstacles(scene, {}, free).nearest(Capsule{away, away, 0.005}, {}));
}

}  // namespace
}  // namespace symscene
