#include "symscene/symmetry/single_object.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

TEST(SingleObject, OfAVaseIsItsAxisAtAnyScaleAndPlace) {
  for (const double scale : {0.001, 1.0, 800.0}) {
    std::mt19937 generator(9);
    const Eigen::Isometry3d motion = testing::random_motion(generator);
    PointCloud cloud = testing::moved(testing::vase(), motion);
    cloud.positions *= static_cast<float>(scale);
    const ObjectSymmetries found = detect_object_symmetries(cloud);
    ASSERT_EQ(found.rotational.size(), 1U) << "scale " << scale;
    const RotationAxis truth{scale * motion.translation(),
                             motion.linear() * Eigen::Vector3d::UnitZ()};
    const SymmetryDifference apart = difference(found.rotational[0].axis, truth, found.centroid);
    EXPECT_LT(apart.angle, radians(1.0));
    EXPECT_LT(apart.distance, 0.003 * scale);
    EXPECT_TRUE(found.reflectional.empty());
    EXPECT_FALSE(found.sphere);
  }
}

TEST(SingleObject, OfABoxIsItsThreePlanesWithAndWithoutNormals) {
  PointCloud cloud = testing::box({0.1, 0.16, 0.23});
  for (const bool with_normals : {true, false}) {
    if (!with_normals) cloud.normals.resize(0, 3);
    const ObjectSymmetries found = detect_object_symmetries(cloud);
    EXPECT_EQ(found.reflectional.size(), 3U) << with_normals;
    EXPECT_TRUE(found.rotational.empty());
  }
}

TEST(SingleObject, OfABallIsASphere) {
  const std::vector<Ellipsoid> ball{{{0.0, 0.0, 0.1}, {0.05, 0.05, 0.05}}};
  const ObjectSymmetries found =
      detect_object_symmetries(testing::as_cloud(make_mirrored_body(ball, 0.001, 0.005)));
  EXPECT_TRUE(found.sphere);
  EXPECT_LT((found.centroid - Eigen::Vector3d(0.0, 0.0, 0.1)).norm(), 0.002);
}

TEST(SingleObject, OfOnePointIsRefused) {
  PointCloud cloud = select(testing::vase(), PointIndices{0});
  EXPECT_THROW(detect_object_symmetries(cloud), InputError);
  EXPECT_THROW(detect_object_symmetries(PointCloud{}), InputError);
}

}  // namespace
}  // namespace symscene
