#include "symscene/classes/class_symmetries.hpp"

#include <gtest/gtest.h>

#include <algorithm>

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

TEST(ClassSymmetries, KeepListedPlanesThatTheClassDoesNotHave) {
  const SymmetryLists lists =
      with_symmetries_of_class({{}, {plane(1.0, 1.0, 0.0, 0.01)}}, unit_box(), same_angle);
  EXPECT_EQ(lists.reflectional.size(), 4U);
  EXPECT_TRUE(std::any_of(
      lists.reflectional.begin(), lists.reflectional.end(), [](const ObjectPlane& listed) {
        return line_angle(listed.plane.normal, Eigen::Vector3d(1, 1, 0)) < radians(5.0);
      }));
}

TEST(ClassSymmetries, KeepTheDiagonalOfABoxWithEqualSides) {
  ObjectClass box = unit_box();
  box.dimensions[1].value = 0.2015;
  const SymmetryLists lists =
      with_symmetries_of_class({{}, {plane(1.0, 0.9, 0.0, 0.01)}}, box, same_angle);
  ASSERT_EQ(lists.reflectional.size(), 4U);
  const Eigen::Vector3d diagonal = Eigen::Vector3d(1, 1, 0).normalized();
  EXPECT_LT((lists.reflectional[0].plane.normal - diagonal).norm(), 1e-12);
  EXPECT_EQ(lists.reflectional[0].plane.point, box.center);
}

TEST(ClassSymmetries, WhereAnEndIsHiddenTheListedPlaneThroughWhatIsSeenGivesTheCentre) {
  ObjectClass box = unit_box();
  box.dimensions[0].sigma.reset();
  ObjectPlane within = plane(1.0, 0.1, 0.0, 0.01), beyond = plane(1.0, 0.0, 0.0, 0.01);
  within.plane.point = {0.03, 0.0, 0.0};
  beyond.plane.point = {0.13, 0.0, 0.0};
  const SymmetryLists lists = with_symmetries_of_class({{}, {within}}, box, same_angle);
  ASSERT_EQ(lists.reflectional.size(), 3U);
  const ObjectClass centred = centred_on_planes(box, lists.reflectional);
  EXPECT_NEAR(centred.center.x(), 0.03, 1e-12);
  for (const ObjectPlane& listed : lists.reflectional)
    EXPECT_NEAR(listed.plane.signed_distance(centred.center), 0.0, 1e-12);
  const SymmetryLists dropped = with_symmetries_of_class({{}, {beyond}}, box, same_angle);
  EXPECT_EQ(dropped.reflectional.size(), 2U);
  EXPECT_EQ(centred_on_planes(box, dropped.reflectional).center, box.center);
}

TEST(ClassSymmetries, NearThoseOfAClassAreMovedThroughItsCentre) {
  const std::vector<ObjectPlane> planes = {plane(1.0, 0.1, 0.0, 0.01), plane(0.0, 1.0, 0.1, 0.02),
                                           plane(0.1, 0.0, 1.0, 0.03), plane(1.0, 0.05, 0.0, 0.04),
                                           plane(1.0, 1.0, 1.0, 0.05)};
  const std::vector<ObjectAxis> axes = {
      {{{0.003, 0.003, 0.003}, Eigen::Vector3d(0.1, 0.0, 1.0).normalized()}, 0.01}};
  using enum SymmetryClass;
  for (const auto& [kind, count] :
       std::vector<std::pair<SymmetryClass, std::size_t>>{{mirror, 1},
                                                          {prism, 2},
                                                          {box, 3},
                                                          {n_fold, 3},
                                                          {revolution, 2},
                                                          {cylinder, 3},
                                                          {sphere, 4}}) {
    const ObjectClass found{.kind = kind, .center = {0.01, 0.02, 0.03}, .order = 6};
    const SymmetryLists lists = with_symmetries_of_class({axes, planes}, found, same_angle);
    const bool has_axis =
        kind == n_fold || kind == revolution || kind == cylinder || kind == sphere;
    const auto moved_planes = std::count_if(
        lists.reflectional.begin(), lists.reflectional.end(), [&](const ObjectPlane& listed) {
          return std::abs(listed.plane.signed_distance(found.center)) < 1e-12;
        });
    const auto moved_axes = std::count_if(
        lists.rotational.begin(), lists.rotational.end(), [&](const ObjectAxis& listed) {
          return (listed.axis.project(found.center) - found.center).norm() < 1e-12;
        });
    EXPECT_EQ(moved_axes, has_axis ? 1 : 0) << to_string(kind);
    EXPECT_EQ(static_cast<std::size_t>(moved_planes), count) << to_string(kind);
  }
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
