#include "symscene/clutter/graspability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "clutter_scenes.hpp"
#include "core/rigid_motion.hpp"
#include "symscene/core/error.hpp"
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

/// An upright prism on the table whose facets lean by turns to the left and to the right, as the
/// facets of scanned surfaces do.
TriangleMesh rough_cylinder(float radius, float height) {
  constexpr Eigen::Index facets = 48;
  TriangleMesh mesh;
  mesh.vertices.resize(2 * facets + 2, 3);
  mesh.triangles.resize(4 * facets, 3);
  mesh.vertices.row(2 * facets) << 0.0F, 0.0F, 0.0F;
  mesh.vertices.row(2 * facets + 1) << 0.0F, 0.0F, height;
  for (Eigen::Index i = 0; i < facets; ++i) {
    const float angle =
        2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(facets);
    const float r = i % 2 == 0 ? radius : 0.95F * radius;
    const auto next = static_cast<Index>((i + 1) % facets), here = static_cast<Index>(i);
    const auto top = static_cast<Index>(facets);
    mesh.vertices.row(i) << r * std::cos(angle), r * std::sin(angle), 0.0F;
    mesh.vertices.row(facets + i) << r * std::cos(angle), r * std::sin(angle), height;
    mesh.triangles.row(4 * i) << here, next, top + next;
    mesh.triangles.row(4 * i + 1) << here, top + next, top + here;
    mesh.triangles.row(4 * i + 2) << next, here, 2 * top;
    mesh.triangles.row(4 * i + 3) << top + here, top + next, 2 * top + 1;
  }
  return mesh;
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
  EXPECT_FALSE(of_box(slab, 0.02).as_it_lies) << "the palm would enter the table";
  EXPECT_TRUE(of_box(slab, 0.12).as_it_lies);
  EXPECT_TRUE(of_box({0.12F, 0.03F, 0.12F}).as_it_lies);
}

TEST(GraspabilityTest, ALowBoxCanBeHeldHoweverItIsTurned) {
  const TriangleMesh box = box_surface({0.03F, 0.09F, 0.008F});
  for (const double angle : {0.0, 15.0, 40.0}) {
    const Eigen::Isometry3d T =
        Eigen::Translation3d(0.0, 0.0, 0.004) *
        Eigen::Isometry3d(Eigen::AngleAxisd(radians(angle), Eigen::Vector3d::UnitZ()));
    EXPECT_TRUE(graspability(transformed(box, T), table, panda_hand(), min_width).as_it_lies)
        << angle;
  }
}

TEST(GraspabilityTest, IsOfParallelGrippersOnly) {
  EXPECT_THROW(graspability(box_surface({0.05F, 0.05F, 0.05F}), table, reflex_gripper()),
               InputError);
}

TEST(GraspabilityTest, AWallThinnerThanAClosedHandCannotBeHeld) {
  EXPECT_FALSE(of_box({0.1F, 0.1F, 0.006F}, 0.1).at_all);
}

TEST(GraspabilityTest, AChordIsNoWidth) {
  // Two facets of this prism that are not opposite have lines between them shorter than 80 mm, all
  // within the cone of friction; the pads would still meet the wider middle.
  EXPECT_FALSE(graspability(rough_cylinder(0.0425F, 0.1F), table, panda_hand(), min_width).at_all);
  EXPECT_TRUE(graspability(rough_cylinder(0.038F, 0.1F), table, panda_hand(), min_width).at_all);
}

}  // namespace
}  // namespace symscene
