#include "symscene/clutter/graspability.hpp"

#include <gtest/gtest.h>

#include "clutter_scenes.hpp"
#include "core/rigid_motion.hpp"
#include "symscene/grasping/gripper.hpp"

namespace symscene {
namespace {

constexpr double min_width = 0.008;
const Plane table{Eigen::Vector3d::UnitZ(), 0.0};

/// Of a box whose lower face is this high above the table.
Graspability of_box(const Eigen::Vector3f& size, double height = 0.0) {
  const Eigen::Isometry3d T(
      Eigen::Translation3d(0.1, -0.2, height + 0.5 * static_cast<double>(size.z())));
  return graspability(transformed(box_surface(size), T), table, panda_hand(), min_width);
}

TEST(GraspabilityTest, ABoxNarrowerThanTheHandOpensCanBeHeld) {
  const Graspability cube = of_box({0.05F, 0.05F, 0.05F});
  EXPECT_TRUE(cube.at_all);
  EXPECT_TRUE(cube.as_it_lies);
}

TEST(GraspabilityTest, ABoxWiderThanTheHandOpensCannot) {
  EXPECT_FALSE(of_box({0.1F, 0.1F, 0.1F}).at_all);
  EXPECT_FALSE(of_box({0.081F, 0.2F, 0.3F}).at_all);
  EXPECT_TRUE(of_box({0.079F, 0.2F, 0.3F}).at_all);
}

TEST(GraspabilityTest, AFlatWideBoxNeedsRoomBeneath) {
  const Eigen::Vector3f slab(0.12F, 0.12F, 0.03F);
  EXPECT_TRUE(of_box(slab).at_all);
  EXPECT_FALSE(of_box(slab).as_it_lies);
  EXPECT_TRUE(of_box(slab, 0.02).as_it_lies);
  EXPECT_TRUE(of_box({0.12F, 0.03F, 0.12F}).as_it_lies);
}

TEST(GraspabilityTest, AWallThinnerThanAClosedHandCannotBeHeld) {
  EXPECT_FALSE(of_box({0.1F, 0.1F, 0.006F}, 0.1).at_all);
}

}  // namespace
}  // namespace symscene
