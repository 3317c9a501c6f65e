#include "classes/class_surface.hpp"

#include <gtest/gtest.h>

#include "symscene/core/types.hpp"

namespace symscene {
namespace {

const SurfaceBounds bounds{{0.002, 0.006}, {radians(15.0), radians(40.0)}};

ObjectClass cylinder(std::optional<double> height_sigma) {
  ObjectClass found{.kind = SymmetryClass::cylinder};
  found.dimensions = {{"radius", 0.04, 0.001}, {"height", 0.1, height_sigma}};
  return found;
}

float residual(const ObjectClass& found, const Eigen::Vector3f& position,
               const Eigen::Vector3f& normal) {
  return ClassSurface(found).residual(position, normal, bounds);
}

TEST(ClassSurface, PointsOnItHaveNoResidualAndOthersGrowByDistanceAndAngle) {
  ObjectClass box{.kind = SymmetryClass::box, .center = {0.1, 0.2, 0.3}};
  box.dimensions = {{"length", 0.2, 0.001}, {"width", 0.1, 0.001}, {"height", 0.06, 0.001}};
  const Eigen::Vector3f x = Eigen::Vector3f::UnitX();
  EXPECT_EQ(residual(box, {0.2F, 0.22F, 0.31F}, x), 0.0F);
  EXPECT_NEAR(residual(box, {0.204F, 0.22F, 0.31F}, x), 0.5F, 1e-3F);
  EXPECT_NEAR(residual(box, {0.196F, 0.22F, 0.31F}, x), 0.5F, 1e-3F);
  EXPECT_EQ(residual(box, {0.21F, 0.22F, 0.31F}, x), 1.0F);
  EXPECT_EQ(residual(box, {0.2F, 0.22F, 0.31F}, -x), 1.0F);
  EXPECT_EQ(residual(box, {0.2F, 0.26F, 0.31F}, x), 1.0F) << "beyond the edge of the face";
}

TEST(ClassSurface, AHiddenEndDoesNotBoundTheSideOfACylinder) {
  const Eigen::Vector3f beyond(0.04F, 0.0F, 0.07F), x = Eigen::Vector3f::UnitX();
  EXPECT_EQ(residual(cylinder(0.001), beyond, x), 1.0F);
  EXPECT_EQ(residual(cylinder(std::nullopt), beyond, x), 0.0F);
}

TEST(ClassSurface, AtTheCentreNothingIsExplained) {
  ObjectClass sphere{.kind = SymmetryClass::sphere};
  sphere.dimensions = {{"radius", 0.03, 0.001}};
  EXPECT_EQ(residual(sphere, {0.0F, 0.0F, 0.0F}, Eigen::Vector3f::UnitX()), 1.0F);
  EXPECT_EQ(residual(sphere, {0.0F, -0.03F, 0.0F}, -Eigen::Vector3f::UnitY()), 0.0F);
}

TEST(ClassSurface, SidesOfAPrismAreBoundedByEachOther) {
  ObjectClass prism{.kind = SymmetryClass::n_fold, .order = 6};
  prism.dimensions = {{"apothem", 0.03, 0.001}, {"height", 0.1, 0.001}};
  const Eigen::Vector3f x = Eigen::Vector3f::UnitX();
  EXPECT_EQ(residual(prism, {0.03F, 0.01F, 0.0F}, x), 0.0F);
  EXPECT_EQ(residual(prism, {0.03F, 0.03F, 0.0F}, x), 1.0F);
}

}  // namespace
}  // namespace symscene
