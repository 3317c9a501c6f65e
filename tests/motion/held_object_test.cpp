#include "motion/held_object.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "small_arm.hpp"

namespace symscene {
namespace {

Eigen::Isometry3d random_pose(Random& random) {
  Eigen::Isometry3d pose(Eigen::Translation3d(random.uniform(0.3, 0.5), random.uniform(-0.1, 0.1),
                                              random.uniform(0.0, 0.2)));
  pose.rotate(Eigen::AngleAxisd(
      random.uniform(0.0, 3.0),
      Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), 1.0).normalized()));
  return pose;
}

/// The nearest obstacle to each point, one after the other.
ObstacleDistance by_brute_force(const std::vector<Eigen::Vector3d>& points,
                                const MotionObstacles& obstacles, const Eigen::Isometry3d& pose,
                                const IgnoredObstacles& ignored) {
  ObstacleDistance least{MotionObstacles::near};
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d p = pose * point;
    const double height = obstacles.table()->signed_distance(p);
    if (height < least.distance) least = {height, ObstacleKind::table, -1};
    const auto found = obstacles.nearest(Capsule{p, p, 0.0}, ignored);
    if (found && found->distance < least.distance) least = *found;
  }
  return least;
}

TEST(HeldObject, IsAsFarFromObstaclesAsItsNearestPoint) {
  GraspScene scene;
  scene.table = Plane{};
  scene.objects = {testing::box_of_points({0.1, 0.1, 0.1}, {0.4, 0.15, 0.05}),
                   testing::box_of_points({0.05, 0.05, 0.2}, {0.45, -0.1, 0.1})};
  const MotionObstacles obstacles(scene);
  Random random(12);
  int near = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < 60; ++k)
      points.emplace_back(random.uniform(-0.05, 0.05), random.uniform(-0.03, 0.03),
                          random.uniform(-0.06, 0.06));
    const HeldObject held(points);
    const Eigen::Isometry3d pose = random_pose(random);
    const IgnoredObstacles ignored{i % 2 - 1, -1};
    const ObstacleDistance expected = by_brute_force(points, obstacles, pose, ignored);
    const ObstacleDistance found = held.nearest(obstacles, pose, ignored);
    EXPECT_NEAR(found.distance, expected.distance, 1e-12);
    if (expected.distance < MotionObstacles::near && expected.kind != ObstacleKind::table) ++near;
  }
  EXPECT_GT(near, 10);
}

TEST(HeldObject, MeetsSurfacesOnlyWithAClearanceAboveTheDepthOfTheirPoints) {
  GraspScene scene;
  scene.table = Plane{};
  scene.objects = {testing::box_of_points({0.1, 0.1, 0.2}, {0.4, 0.0, 0.1})};
  const MotionObstacles obstacles(scene);
  // A point on the box's surface and one 30 mm off it.
  const HeldObject held({{0.35, 0.0, 0.1}}), away({{0.32, 0.0, 0.1}});
  const Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  EXPECT_LT(held.nearest(obstacles, pose, {}).distance, 0.001);
  EXPECT_GE(held.nearest(obstacles, pose, {}).distance, -0.0031);
  EXPECT_GT(away.nearest(obstacles, pose, {}).distance, 0.001);
  // The table 20 mm lower.
  const HeldObject low({{0.0, 0.0, -0.01}});
  EXPECT_NEAR(low.nearest(obstacles, pose, {}).distance, -0.01, 1e-9);
  EXPECT_NEAR(low.nearest(obstacles, pose, {}, 0.02).distance, 0.01, 1e-9);
}

}  // namespace
}  // namespace symscene
