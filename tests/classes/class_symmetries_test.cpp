#include "symscene/classes/class_symmetries.hpp"

#include <gtest/gtest.h>

namespace symscene {
namespace {

constexpr double same_angle = radians(12.0);

ObjectClass unit_box() {
  ObjectClass box{.kind = SymmetryClass::box, .explained = 0.95};
  box.dimensions = {{"length", 0.2, 0.001}, {"width", 0.1, 0.001}, {"height", 0.05, 0.001}};
  return box;
}

ObjectPlane plane(double x, double y, double z, double residual) {
  return {{{0.004, 0.004, 0.004}, Eigen::Vector3d(x, y, z).normalized()}, residual};
}

TEST(ClassSymmetries, AddThePlanesOfABoxAndMoveThoseThatAreListed) {
  const SymmetryLists lists =
      with_symmetries_of_class({{}, {plane(1.0, 0.1, 0.0, 0.01)}}, unit_box(), same_angle);
  ASSERT_EQ(lists.reflectional.size(), 3U);
  EXPECT_EQ(lists.reflectional[0].residual, 0.01);
  EXPECT_EQ(lists.reflectional[0].plane.normal, Eigen::Vector3d::UnitX());
  EXPECT_EQ(lists.reflectional[0].plane.point, Eigen::Vector3d::Zero());
}

TEST(ClassSymmetries, LeaveOutPlanesWhoseEndsAreHidden) {
  ObjectClass box = unit_box();
  box.dimensions[1].sigma.reset();
  const SymmetryLists lists = with_symmetries_of_class({}, box, same_angle);
  ASSERT_EQ(lists.reflectional.size(), 2U);
  for (const ObjectPlane& listed : lists.reflectional) EXPECT_EQ(listed.plane.normal.y(), 0.0);
}

TEST(ClassSymmetries, KeepOtherListedPlanes) {
  const SymmetryLists lists =
      with_symmetries_of_class({{}, {plane(1.0, 1.0, 0.0, 0.01)}}, unit_box(), same_angle);
  EXPECT_EQ(lists.reflectional.size(), 4U);
}

TEST(ClassSymmetries, AddTheAxisOfACylinderInPlaceOfPlanesThroughIt) {
  ObjectClass can{.kind = SymmetryClass::cylinder, .explained = 0.95};
  can.dimensions = {{"radius", 0.04, 0.001}};
  const SymmetryLists lists = with_symmetries_of_class(
      {{}, {plane(1.0, 0.1, 0.0, 0.01), plane(0.0, 0.0, 1.0, 0.02)}}, can, same_angle);
  ASSERT_EQ(lists.rotational.size(), 1U);
  EXPECT_EQ(lists.rotational[0].axis.direction, Eigen::Vector3d::UnitZ());
  ASSERT_EQ(lists.reflectional.size(), 1U);
  EXPECT_EQ(lists.reflectional[0].plane.normal, Eigen::Vector3d::UnitZ());
}

TEST(ClassSymmetries, OfASurfaceWithoutDimensionsAreThoseListed) {
  ObjectClass box = unit_box();
  box.dimensions.clear();
  EXPECT_TRUE(with_symmetries_of_class({}, box, same_angle).reflectional.empty());
  const ObjectClass can{.kind = SymmetryClass::cylinder, .explained = 0.95};
  const SymmetryLists listed =
      with_symmetries_of_class({{}, {plane(1.0, 0.1, 0.0, 0.01)}}, can, same_angle);
  EXPECT_TRUE(listed.rotational.empty());
  EXPECT_EQ(listed.reflectional.size(), 1U);
}

}  // namespace
}  // namespace symscene
