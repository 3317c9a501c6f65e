#include "view_planning/voxel_walk.hpp"

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace symscene {
namespace {

VoxelFrame frame() {
  VoxelFrame frame;
  frame.origin = {-0.1F, 0.2F, 0.0F};
  frame.resolution = 0.01F;
  frame.size = {20, 12, 9};
  return frame;
}

Eigen::Array3i cell_of(const VoxelFrame& frame, std::size_t voxel) {
  return {static_cast<int>(voxel % frame.row_length()),
          static_cast<int>(voxel % frame.slice_length() / frame.row_length()),
          static_cast<int>(voxel / frame.slice_length())};
}

TEST(VoxelWalk, VisitsTheVoxelsOfTheRayInOrder) {
  const VoxelFrame f = frame();
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const auto draw = [&] { return static_cast<float>(random.uniform(-0.3, 0.5)); };
    const Eigen::Vector3f origin(draw(), draw(), draw());
    const Eigen::Vector3f direction(draw() - 0.1F, draw() - 0.1F, draw() - 0.1F);
    float last = 0.0F;
    Eigen::Array3i before = Eigen::Array3i::Constant(-1);
    for (VoxelWalk walk(f, origin, direction); walk.is_inside(); walk.advance()) {
      const Eigen::Array3i cell = cell_of(f, walk.voxel());
      EXPECT_GE(walk.distance(), last);
      last = walk.distance();
      // The voxel holds the point where the ray enters it, up to rounding.
      const Eigen::Array3f at =
          ((origin + walk.distance() * direction) - f.origin).array() / f.resolution;
      EXPECT_TRUE((at > cell.cast<float>() - 1e-2F).all() &&
                  (at < cell.cast<float>() + 1.0F + 1e-2F).all());
      if (before[0] >= 0) {
        EXPECT_EQ((cell - before).abs().sum(), 1) << "one face at a time";
      }
      before = cell;
    }
  }
}

TEST(VoxelWalk, BeginsInTheVoxelOfItsOrigin) {
  const VoxelFrame f = frame();
  const Eigen::Vector3f origin = f.origin + Eigen::Vector3f(0.055F, 0.035F, 0.025F);
  const VoxelWalk walk(f, origin, Eigen::Vector3f::UnitX());
  ASSERT_TRUE(walk.is_inside());
  EXPECT_TRUE((cell_of(f, walk.voxel()) == Eigen::Array3i(5, 3, 2)).all());
  EXPECT_EQ(walk.distance(), 0.0F);
}

TEST(VoxelWalk, MissesAGridBesideTheRay) {
  EXPECT_FALSE(VoxelWalk(frame(), {0.0F, 0.0F, 0.05F}, Eigen::Vector3f::UnitX()).is_inside());
  EXPECT_FALSE(VoxelWalk(frame(), {0.5F, 0.25F, 0.05F}, Eigen::Vector3f::UnitX()).is_inside());
}

}  // namespace
}  // namespace symscene
