#include "segmentation/surface_patches.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "core/random.hpp"
#include "surfaces.hpp"
#include "symscene/segmentation/surface_graph.hpp"

namespace symscene {
namespace {

SurfacePatch patch_at(const Eigen::Vector3f& center, const Eigen::Vector3f& normal) {
  return {center, normal.normalized(), {0}};
}

TEST(SurfacePatches, HoldEveryPointOnceAndFaceOneWay) {
  const PointCloud cube = testing::box({0.1, 0.12, 0.14});
  const std::vector<SurfacePatch> patches = surface_patches(cube, surface_graph(cube), {});
  std::vector<int> held(cube.size(), 0);
  std::size_t aligned = 0;
  for (const SurfacePatch& patch : patches) {
    for (const Index i : patch.points) {
      ++held[i];
      aligned += patch.normal.dot(cube.normal(i)) > 0.9F ? 1 : 0;
    }
  }
  EXPECT_TRUE(std::all_of(held.begin(), held.end(), [](int count) { return count == 1; }));
  EXPECT_GT(aligned, 95 * std::size_t{cube.size()} / 100);
  // About one per square of the option's size on the surface of the box.
  EXPECT_GT(patches.size(), 100U);
  EXPECT_LT(patches.size(), 400U);
}

TEST(SurfacePatches, AreConcaveByTheAngleOfTheFold) {
  const float right_angle = 0.5F * std::numbers::pi_v<float>;
  const SurfacePatch floor = patch_at({0.01F, 0.0F, 0.0F}, Eigen::Vector3f::UnitZ());
  const SurfacePatch wall = patch_at({0.0F, 0.0F, 0.01F}, Eigen::Vector3f::UnitX());
  EXPECT_NEAR(patch_concavity(floor, wall), right_angle, 1e-5F);
  const SurfacePatch below = patch_at({0.0F, 0.0F, -0.01F}, -Eigen::Vector3f::UnitX());
  EXPECT_EQ(patch_concavity(floor, below), 0.0F);  // the edge of a box
  const SurfacePatch beside = patch_at({0.03F, 0.01F, 0.0F}, Eigen::Vector3f::UnitZ());
  EXPECT_NEAR(patch_concavity(floor, beside), 0.0F, 1e-5F);
  const SurfacePatch step = patch_at({0.03F, 0.0F, 0.02F}, Eigen::Vector3f::UnitZ());
  EXPECT_NEAR(patch_concavity(floor, step), 0.5F * right_angle, 1e-5F);
}

TEST(SurfacePatches, AreAsConcaveFromBothSidesAndInAnyPose) {
  Random random(5);
  const auto direction = [&] {
    return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).cast<float>().eval();
  };
  for (int k = 0; k < 200; ++k) {
    const SurfacePatch a = patch_at(direction(), direction()),
                       b = patch_at(direction(), direction());
    const float concavity = patch_concavity(a, b);
    EXPECT_NEAR(patch_concavity(b, a), concavity, 1e-5F);
    const Eigen::Matrix3f turn =
        Eigen::Quaternionf(
            Eigen::Vector4f(direction().x(), direction().y(), direction().z(), 0.3F).normalized())
            .toRotationMatrix();
    EXPECT_NEAR(patch_concavity(patch_at(turn * a.center, turn * a.normal),
                                patch_at(turn * b.center, turn * b.normal)),
                concavity, 1e-3F);
  }
}

TEST(SurfacePatches, AcrossASmallGapAreAdjacent) {
  const std::vector<SurfacePatch> patches{patch_at({0.0F, 0.0F, 0.0F}, Eigen::Vector3f::UnitZ()),
                                          patch_at({0.03F, 0.0F, 0.0F}, Eigen::Vector3f::UnitZ()),
                                          patch_at({0.1F, 0.0F, 0.0F}, Eigen::Vector3f::UnitZ())};
  const std::vector<std::pair<Index, Index>> expected{{0, 1}};
  EXPECT_EQ(patches_across_gaps(patches, {}), expected);
}

}  // namespace
}  // namespace symscene
