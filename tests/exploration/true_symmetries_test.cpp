#include "exploration/true_symmetries.hpp"

#include <gtest/gtest.h>

#include "clutter/clutter_scenes.hpp"
#include "simulation/shapes.hpp"

namespace symscene {
namespace {

const Eigen::Vector3f box_size{0.04F, 0.06F, 0.10F};

std::size_t strict_planes(const TrueObject& object) {
  return static_cast<std::size_t>(std::count_if(object.reflectional.begin(),
                                                object.reflectional.end(),
                                                [](const TruePlane& own) { return own.strict; }));
}

/// About the axis z.
TriangleMesh can_surface() {
  const std::vector<ProfilePoint> profile{{0.0, 0.0}, {0.03, 0.0}, {0.03, 0.12}, {0.0, 0.12}};
  return make_revolution(profile, 96, 0.01);
}

TEST(TrueSymmetries, OfABoxAreItsThreePlanesThroughItsCentre) {
  const TrueObject box = true_symmetries("box", box_surface(box_size));
  EXPECT_EQ(box.name, "box");
  EXPECT_TRUE(box.rotational.empty());
  EXPECT_FALSE(box.sphere);
  ASSERT_EQ(box.reflectional.size(), 3U);
  EXPECT_EQ(strict_planes(box), 3U);
  EXPECT_LT(box.centroid.norm(), 1e-3);
}

TEST(TrueSymmetries, OfACanAreItsAxisAndAWeakPlaneAcrossIt) {
  const TrueObject can = true_symmetries("can", can_surface());
  ASSERT_EQ(can.rotational.size(), 1U);
  EXPECT_TRUE(can.rotational[0].strict);
  EXPECT_GT(std::abs(can.rotational[0].axis.direction.z()), std::cos(radians(1.0)));
  ASSERT_EQ(can.reflectional.size(), 1U);
  EXPECT_EQ(strict_planes(can), 0U);
}

TEST(TrueSymmetries, OfAPlacedObjectAreThoseOfItsSurfaceThere) {
  const double scale = 0.8;
  const Eigen::Isometry3d T = Eigen::Translation3d(0.1, 0.2, 0.3) *
                              Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized());
  TriangleMesh moved = box_surface(box_size * static_cast<float>(scale));
  moved.vertices = (moved.vertices * T.linear().cast<float>().transpose()).rowwise() +
                   T.translation().cast<float>().transpose();
  const TrueObject there = true_symmetries("box", moved);
  const TrueObject here = placed(true_symmetries("box", box_surface(box_size)), scale, T);
  EXPECT_LT((there.centroid - here.centroid).norm(), 1e-3);
  ASSERT_EQ(there.reflectional.size(), here.reflectional.size());
  for (const TruePlane& own : here.reflectional) {
    EXPECT_TRUE(std::any_of(there.reflectional.begin(), there.reflectional.end(),
                            [&](const TruePlane& other) {
                              const auto apart = difference(own.plane, other.plane, here.centroid);
                              return apart.angle < radians(1.0) && apart.distance < 1e-3;
                            }));
  }
}

}  // namespace
}  // namespace symscene
