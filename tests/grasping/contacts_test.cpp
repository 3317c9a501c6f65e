#include "grasping/contacts.hpp"

#include <gtest/gtest.h>

#include "grasp_scenes.hpp"

namespace symscene {
namespace {

/// Straight down over (x, y), the fingers closing along y, the tips at a height.
Eigen::Isometry3d from_above(const Gripper& gripper, double x, double y, double tips) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Vector3d(-1.0, 1.0, -1.0).asDiagonal();
  pose.translation() = Eigen::Vector3d(x, y, tips + gripper.finger_depth);
  return pose;
}

TEST(Contacts, TouchTheFacesOfABox) {
  const Gripper gripper = panda_hand();
  const SurfaceSamples samples =
      surface_samples(testing::box_at({0.1, 0.04, 0.06}, 0.0, 0.01).surface);
  const auto contacts = find_contacts(samples, from_above(gripper, 0.0, 0.0, 0.03), gripper, 0.002);
  ASSERT_TRUE(contacts);
  EXPECT_NEAR(contacts->opening(), 0.04, 1e-4);
  EXPECT_NEAR(contacts->positive.y, 0.03, 1e-4);
  EXPECT_NEAR(contacts->negative.y, -0.01, 1e-4);
  EXPECT_NEAR(contacts->positive.normal.y(), 1.0, 1e-3);
  EXPECT_NEAR(contacts->negative.normal.y(), -1.0, 1e-3);
  EXPECT_EQ(contacts->positive.cone_share, 1.0);
  EXPECT_EQ(contacts->positive.observed, 1.0);
  // A finger 21 mm wide on 30 mm of the face, up to a sample's share.
  EXPECT_NEAR(contacts->positive.area, 0.021 * 0.03, 0.25 * 0.021 * 0.03);
}

TEST(Contacts, OfARoundObjectAreSmallerThanOfAFlatOne) {
  const Gripper gripper = panda_hand();
  const SurfaceSamples round = surface_samples(testing::cylinder_at(0.015, 0.08, 0.0, 0.0).surface);
  const SurfaceSamples flat = surface_samples(testing::box_at({0.03, 0.03, 0.08}, 0, 0).surface);
  const Eigen::Isometry3d pose = from_above(gripper, 0.0, 0.0, 0.03);
  const auto on_round = find_contacts(round, pose, gripper, 0.002);
  const auto on_flat = find_contacts(flat, pose, gripper, 0.002);
  ASSERT_TRUE(on_round && on_flat);
  EXPECT_LT(on_round->positive.area, 0.9 * on_flat->positive.area);
}

TEST(Contacts, AreNoneWhereAPadMeetsNothing) {
  const Gripper gripper = panda_hand();
  const SurfaceSamples samples = surface_samples(testing::box_at({0.1, 0.04, 0.06}, 0, 0).surface);
  EXPECT_FALSE(find_contacts(samples, from_above(gripper, 0.1, 0.0, 0.03), gripper, 0.002));
}

TEST(Contacts, OfAPairOfFingersAreNoneWhereOneOfThemMeetsNothing) {
  const Gripper gripper = reflex_gripper();
  const double reach = 0.5 * gripper.finger_spacing + gripper.finger_width;
  const auto touch = [&](double x, double width) {
    const SurfaceSamples samples =
        surface_samples(testing::box_at({width, 0.04, 0.06}, x, 0.0).surface);
    return find_contacts(samples, from_above(gripper, 0.0, 0.0, 0.03), gripper, 0.002).has_value();
  };
  EXPECT_TRUE(touch(0.0, 2.0 * reach));
  EXPECT_FALSE(touch(0.5 * reach, reach));  // below one finger of the pair and the thumb
}

TEST(SurfaceSamples, StandForTheAreaOfTheSurface) {
  const GraspObject box = testing::box_at({0.1, 0.04, 0.06}, 0.0, 0.0);
  const SurfaceSamples samples = surface_samples(box.surface);
  const double area = 2.0 * (0.1 * 0.04 + 0.1 * 0.06 + 0.04 * 0.06);
  EXPECT_NEAR(samples.areas.sum(), area, 0.02 * area);
  const PointBlocks& blocks = samples.blocks;
  for (Eigen::Index b = 0; b < blocks.size(); ++b) {
    for (Eigen::Index i = blocks.begin(b); i < blocks.end(b); ++i)
      EXPECT_LE((samples.positions.row(i) - blocks.centres.row(b)).norm(), blocks.radii[b] + 1e-6F);
  }
  EXPECT_EQ(blocks.ends.back(), samples.size());
}

TEST(SurfaceSamples, KeepBothSidesOfAThinWall) {
  const GraspObject plate = testing::box_at({0.1, 0.002, 0.06}, 0.0, 0.0);
  const SurfaceSamples samples = surface_samples(plate.surface);
  EXPECT_NEAR(samples.positions.col(1).maxCoeff(), 0.001, 1e-5);
  EXPECT_NEAR(samples.positions.col(1).minCoeff(), -0.001, 1e-5);
}

}  // namespace
}  // namespace symscene
