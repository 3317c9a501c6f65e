#include <gtest/gtest.h>

#include "grasp_scenes.hpp"
#include "grasping/cylinder_candidates.hpp"
#include "grasping/hand_collision.hpp"
#include "scaled_options.hpp"
#include "similarity.hpp"
#include "surfaces.hpp"
#include "symscene/core/error.hpp"
#include "symscene/grasping/gripper.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using testing::joined;
using testing::moved;
using testing::swept_boxes;

/// A solid cylinder that stands on z = 0.
PointCloud can(double radius, double height, const Eigen::Vector3d& position = {0.0, 0.0, 0.0}) {
  const std::array<ProfilePoint, 4> profile{
      ProfilePoint{0.0, 0.0}, {radius, 0.0}, {radius, height}, {0.0, height}};
  return moved(testing::as_cloud(make_revolution(profile, 96, 0.005)),
               Eigen::Isometry3d(Eigen::Translation3d(position)));
}

Plane moved_table(const Eigen::Isometry3d& motion) {
  const Eigen::Vector3d normal = motion.linear() * Eigen::Vector3d::UnitZ();
  return {normal, -normal.dot(motion.translation())};
}

Scene on_table(const PointCloud& cloud,
               const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity()) {
  return {moved(cloud, motion), std::nullopt, moved_table(motion)};
}

/// One cylinder of known size, and no point of another object.
CylinderScene known_cylinder(const BoundingCylinder& cylinder, const std::optional<Plane>& table) {
  CylinderScene scene;
  scene.table = table;
  scene.clusters.emplace_back();
  scene.clusters[0].cylinder = cylinder;
  scene.clusters[0].judgement.outcome = AxisOutcome::accepted;
  return scene;
}

std::size_t count_of(const GraspPlan& plan, std::size_t object, GraspRejection reason) {
  return plan.objects.at(object).rejected.at(static_cast<std::size_t>(reason));
}

TEST(BoundingCylinder, HoldsAllPointsAndTouchesThemOnItsSideAndBothCaps) {
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const Points points = testing::random_points(seed, 200);
    const RotationAxis axis{testing::random_vector(generator, 0.1),
                            testing::random_direction(generator)};
    const BoundingCylinder cylinder = bounding_cylinder(points, axis);
    double farthest = 0.0, highest = -1.0, lowest = 1.0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      const Eigen::Vector3d point = points.row(i).transpose().cast<double>();
      const double along = cylinder.direction.dot(point - cylinder.center);
      highest = std::max(highest, along);
      lowest = std::min(lowest, along);
      farthest = std::max(farthest, axis.distance(point));
    }
    EXPECT_NEAR(farthest, cylinder.radius, 1e-12);
    EXPECT_NEAR(highest, 0.5 * cylinder.height, 1e-9);
    EXPECT_NEAR(lowest, -0.5 * cylinder.height, 1e-9);
    EXPECT_LT(axis.distance(cylinder.center), 1e-9);
  }
}

TEST(BoundingCylinder, NeedsAPoint) {
  EXPECT_THROW(bounding_cylinder(Points(0, 3), RotationAxis{}), InputError);
}

TEST(FitCylinders, FindsSizeAndPlaceOfTwoCansAtAnyPoseOfTheScene) {
  const PointCloud cans = joined(can(0.05, 0.08), can(0.03, 0.15, {0.15, 0.0, 0.0}));
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const Eigen::Isometry3d motion = testing::random_motion(generator);
    const CylinderScene scene = fit_cylinders(on_table(cans, motion));
    ASSERT_EQ(scene.clusters.size(), 2U) << "seed " << seed;
    // The larger surface first: 0.0408 m² and 0.0339 m².
    const std::array<BoundingCylinder, 2> truth{
        BoundingCylinder{{0.0, 0.0, 0.04}, Eigen::Vector3d::UnitZ(), 0.05, 0.08},
        {{0.15, 0.0, 0.075}, Eigen::Vector3d::UnitZ(), 0.03, 0.15}};
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_TRUE(scene.clusters[i].cylinder) << to_string(scene.clusters[i].judgement.outcome);
      const BoundingCylinder& found = *scene.clusters[i].cylinder;
      EXPECT_NEAR(found.radius, truth[i].radius, 0.002);
      EXPECT_NEAR(found.height, truth[i].height, 0.004);
      EXPECT_LT((found.center - motion * truth[i].center).norm(), 0.003);
      EXPECT_LT(angle_between(found.direction, motion.linear() * truth[i].direction), radians(1.5));
    }
  }
}

TEST(FitCylinders, OfASceneTwiceAsLargeAreTwiceAsLarge) {
  const PointCloud cans = joined(can(0.05, 0.08), can(0.03, 0.15, {0.15, 0.0, 0.0}));
  constexpr double scale = 2.0;  // free space is prepared at a scale that is no option
  const CylinderScene here = fit_cylinders(on_table(cans));
  const CylinderScene there = fit_cylinders(on_table(testing::scaling_by(scale)(cans)),
                                            testing::scaled_lengths(CylinderOptions{}, scale));
  ASSERT_EQ(here.clusters.size(), 2U);
  ASSERT_EQ(there.clusters.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_TRUE(here.clusters[i].cylinder && there.clusters[i].cylinder);
    const BoundingCylinder& small = *here.clusters[i].cylinder;
    const BoundingCylinder& found = *there.clusters[i].cylinder;
    const double distance = testing::rounding * scale;
    EXPECT_NEAR(found.radius, scale * small.radius, distance);
    EXPECT_NEAR(found.height, scale * small.height, distance);
    EXPECT_LT((found.center - scale * small.center).norm(), distance);
    EXPECT_LT(line_angle(found.direction, small.direction), testing::rounding);
  }
}

TEST(FitCylinders, KeepsTheReasonOfAClusterWithoutAnAxis) {
  const PointCloud box = testing::box({0.06, 0.12, 0.2});
  const CylinderScene scene = fit_cylinders(on_table(box));
  ASSERT_EQ(scene.clusters.size(), 1U);
  EXPECT_FALSE(scene.clusters[0].cylinder);
  EXPECT_EQ(scene.clusters[0].judgement.outcome, AxisOutcome::symmetry);
  EXPECT_GE(scene.clusters[0].judgement.value, scene.clusters[0].judgement.bound);

  const CylinderScene sheet = fit_cylinders(on_table(testing::seen_from(box, {0.0F, 0.0F, 0.21F})));
  ASSERT_EQ(sheet.clusters.size(), 1U);
  EXPECT_FALSE(sheet.clusters[0].cylinder);
  EXPECT_EQ(sheet.clusters[0].judgement.outcome, AxisOutcome::perpendicularity);
}

TEST(FitCylinders, FindsNothingOnAnEmptyTable) {
  Scene empty;
  empty.table = Plane{};
  empty.warnings = {"nothing stands on the table"};
  const CylinderScene scene = fit_cylinders(empty);
  EXPECT_TRUE(scene.clusters.empty());
  EXPECT_EQ(scene.warnings, empty.warnings);
  EXPECT_TRUE(cylinder_grasps(scene, panda_hand()).grasps.empty());
}

TEST(FitCylinders, GivesTheSameResultForAnyNumberOfThreads) {
  const Scene scene = on_table(joined(can(0.05, 0.08), can(0.03, 0.15, {0.15, 0.0, 0.0})));
  const auto run = [&](std::size_t threads) {
    return testing::with_threads(threads,
                                 [&] { return plan_cylinder_grasps(scene, panda_hand()); });
  };
  const std::vector<Grasp> one = run(1), many = run(8);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].T_world_tool.matrix(), many[i].T_world_tool.matrix());
    EXPECT_EQ(one[i].quality, many[i].quality);
  }
}

TEST(CylinderGrasps, HoldTheWholeWidthBetweenTheFingersOfEveryGripper) {
  const double radius = 0.018, height = 0.12;
  const BoundingCylinder cylinder{{0.3, -0.2, 0.06}, Eigen::Vector3d::UnitZ(), radius, height};
  const RotationAxis axis{cylinder.center, cylinder.direction};
  for (const std::string_view name : gripper_names()) {
    const Gripper gripper = named_gripper(name);
    const GraspPlan plan = cylinder_grasps(known_cylinder(cylinder, Plane{}), gripper);
    ASSERT_FALSE(plan.grasps.empty()) << name;
    for (const Grasp& grasp : plan.grasps) {
      const Eigen::Matrix3d& R = grasp.T_world_tool.linear();
      EXPECT_NEAR((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-9);
      EXPECT_NEAR(R.determinant(), 1.0, 1e-9);
      EXPECT_DOUBLE_EQ(grasp.opening, 2.0 * radius);
      // The axis lies in the plane midway between the fingers, which close across it.
      EXPECT_NEAR(R.col(1).dot(cylinder.direction), 0.0, 1e-9);
      EXPECT_NEAR(R.col(1).dot(cylinder.center - grasp.T_world_tool.translation()), 0.0, 1e-9);
      // The tips have passed the whole cylinder from the side, or the upper cap from above.
      const Eigen::Vector3d tips =
          grasp.T_world_tool.translation() + gripper.finger_depth * R.col(2);
      const bool from_above = R.col(2).z() < -0.5;
      if (from_above) {
        EXPECT_LT(tips.z(), height);
      } else {
        // To the far side: the fingers of all of them are long enough.
        EXPECT_NEAR(R.col(2).dot(tips - axis.project(tips)), radius, 1e-9);
      }
    }
  }
}

TEST(CylinderGrasps, RespectTheSizeOfTheCylinder) {
  const Gripper panda = panda_hand();
  const CylinderGraspOptions options;
  BoundingCylinder cylinder{{0.0, 0.0, 0.1}, Eigen::Vector3d::UnitZ(), 0.0, 0.2};
  cylinder.radius = 0.5 * (panda.max_opening - options.opening_margin) + 1e-6;
  const GraspPlan wide = cylinder_grasps(known_cylinder(cylinder, Plane{}), panda);
  EXPECT_TRUE(wide.grasps.empty());
  EXPECT_EQ(wide.objects.at(0).reason, GraspRejection::too_wide);
  EXPECT_EQ(count_of(wide, 0, GraspRejection::too_wide), wide.objects[0].candidates);
  cylinder.radius -= 2e-6;
  EXPECT_FALSE(cylinder_grasps(known_cylinder(cylinder, Plane{}), panda).grasps.empty());

  Gripper thick = panda;
  thick.min_opening = 0.05;
  cylinder.radius = 0.02;
  const GraspPlan thin = cylinder_grasps(known_cylinder(cylinder, Plane{}), thick);
  EXPECT_EQ(thin.objects.at(0).reason, GraspRejection::too_thin);

  Gripper shallow = reflex_gripper();
  shallow.finger_depth = 0.05;
  cylinder.radius = 0.06;
  const GraspPlan sides = cylinder_grasps(known_cylinder(cylinder, Plane{}), shallow);
  EXPECT_GT(count_of(sides, 0, GraspRejection::no_contact), 0U);
  for (const Grasp& grasp : sides.grasps) EXPECT_LT(grasp.T_world_tool.linear()(2, 2), -0.9);
}

TEST(CylinderGrasps, StayAboveTheTable) {
  const BoundingCylinder cylinder{{0.0, 0.0, 0.05}, Eigen::Vector3d::UnitZ(), 0.03, 0.1};
  const Gripper panda = panda_hand();
  const GraspPlan plan = cylinder_grasps(known_cylinder(cylinder, Plane{}), panda);
  const std::vector<HandBox> boxes = swept_boxes(panda);
  ASSERT_FALSE(plan.grasps.empty());
  for (const Grasp& grasp : plan.grasps)
    EXPECT_GE(height_over(Plane{}, grasp.T_world_tool, boxes),
              CylinderGraspOptions{}.table_clearance);
  EXPECT_GT(count_of(plan, 0, GraspRejection::table), 0U);
  for (const RejectedGrasp& rejected : plan.rejected) EXPECT_LT(rejected.value, rejected.bound);
  // Without a table the same cylinder has more, also from below.
  EXPECT_GT(cylinder_grasps(known_cylinder(cylinder, std::nullopt), panda).grasps.size(),
            plan.grasps.size());
}

TEST(CylinderGrasps, KeepABoundedNumberOfRejectedOnesPerReasonAndCountAll) {
  const BoundingCylinder cylinder{{0.0, 0.0, 0.05}, Eigen::Vector3d::UnitZ(), 0.03, 0.1};
  CylinderGraspOptions options;
  options.max_rejected = 100000;
  const GraspPlan all = cylinder_grasps(known_cylinder(cylinder, Plane{}), panda_hand(), options);
  options.max_rejected = 3;
  const GraspPlan few = cylinder_grasps(known_cylinder(cylinder, Plane{}), panda_hand(), options);
  EXPECT_EQ(few.objects.at(0).rejected, all.objects.at(0).rejected);
  EXPECT_EQ(few.objects.at(0).candidates, all.objects.at(0).candidates);
  for (std::size_t k = 0; k < grasp_rejections; ++k) {
    const auto kept = [&](const GraspPlan& plan) {
      return static_cast<std::size_t>(std::count_if(
          plan.rejected.begin(), plan.rejected.end(), [&](const RejectedGrasp& rejected) {
            return rejected.reason == static_cast<GraspRejection>(k);
          }));
    };
    const std::size_t counted = all.objects.at(0).rejected.at(k);
    EXPECT_EQ(kept(all), counted);
    EXPECT_EQ(kept(few), std::min<std::size_t>(3, counted));
  }
  EXPECT_GT(all.rejected.size(), few.rejected.size());
}

TEST(CylinderGrasps, MissThePointsOfOtherClusters) {
  const Scene scene = on_table(joined(can(0.03, 0.12), can(0.03, 0.12, {0.08, 0.0, 0.0})));
  const CylinderScene cylinders = fit_cylinders(scene);
  ASSERT_EQ(cylinders.clusters.size(), 2U);
  const Gripper panda = panda_hand();
  const GraspPlan plan = cylinder_grasps(cylinders, panda);
  const std::vector<HandBox> boxes = swept_boxes(panda);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(plan.objects.at(i).grasps, 0U);
    EXPECT_GT(count_of(plan, i, GraspRejection::other_object), 0U);
  }
  for (const Grasp& grasp : plan.grasps) {
    const PointIndices& others = cylinders.clusters[grasp.object == 0 ? 1 : 0].points;
    const Points points = select(cylinders.cloud, others).positions;
    const Eigen::Isometry3f T_tool_world = grasp.T_world_tool.inverse().cast<float>();
    EXPECT_GE(least_distance(surface_samples(points), T_tool_world, boxes, {0.01F, -1.0F}), 0.0F);
  }
}

TEST(CylinderGrasps, MoveWithTheScene) {
  const BoundingCylinder cylinder{{0.1, 0.2, 0.05}, Eigen::Vector3d::UnitZ(), 0.03, 0.1};
  const GraspPlan plan = cylinder_grasps(known_cylinder(cylinder, Plane{}), panda_hand());
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const Eigen::Isometry3d motion = testing::random_motion(generator);
    BoundingCylinder there = cylinder;
    there.center = motion * cylinder.center;
    there.direction = motion.linear() * cylinder.direction;
    const GraspPlan turned =
        cylinder_grasps(known_cylinder(there, moved_table(motion)), panda_hand());
    // Grasps may be turned about the axis, which changes neither their heights nor their qualities.
    ASSERT_EQ(turned.grasps.size(), plan.grasps.size());
    EXPECT_EQ(turned.objects.at(0).rejected, plan.objects.at(0).rejected);
    for (std::size_t i = 0; i < plan.grasps.size(); ++i)
      EXPECT_NEAR(turned.grasps[i].quality, plan.grasps[i].quality, 1e-9);
  }
}

TEST(CylinderGrasps, AreSortedByAQualityInZeroToOne) {
  const CylinderScene scene =
      fit_cylinders(on_table(joined(can(0.03, 0.2), testing::box({0.05, 0.09, 0.13}))));
  const GraspPlan plan = cylinder_grasps(scene, panda_hand());
  for (std::size_t i = 0; i < plan.grasps.size(); ++i) {
    EXPECT_GE(plan.grasps[i].quality, 0.0);
    EXPECT_LE(plan.grasps[i].quality, i == 0 ? 1.0 : plan.grasps[i - 1].quality);
  }
}

TEST(CylinderGrasps, GiveNoneForAClusterWithoutACylinder) {
  CylinderScene scene = known_cylinder({}, Plane{});
  scene.clusters[0].cylinder.reset();
  const GraspPlan plan = cylinder_grasps(scene, panda_hand());
  EXPECT_TRUE(plan.grasps.empty());
  ASSERT_EQ(plan.objects.size(), 1U);
  EXPECT_EQ(plan.objects[0].candidates, 0U);
  EXPECT_EQ(plan.objects[0].reason, GraspRejection::no_axis);
}

TEST(CylinderGrasps, RefuseAnInvalidGripperAndInvalidOptions) {
  Gripper closed = panda_hand();
  closed.max_opening = closed.min_opening;
  EXPECT_THROW(cylinder_grasps({}, closed), InputError);
  CylinderGraspOptions options;
  options.directions = 0;
  EXPECT_THROW(cylinder_grasps({}, panda_hand(), options), InputError);
  CylinderOptions all;
  all.clusters.distance = 0.0;
  EXPECT_THROW(fit_cylinders(on_table(can(0.03, 0.1)), all), InputError);
}

}  // namespace
}  // namespace symscene
