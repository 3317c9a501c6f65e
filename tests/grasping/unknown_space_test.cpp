#include "grasping/unknown_space.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace symscene {
namespace {

constexpr float coarse_edge = 0.02F;  // of two voxels [m]

OccupancyGrid never_seen() {
  OccupancyGrid grid;
  grid.frame.origin = {-0.2F, -0.1F, 0.0F};
  grid.frame.resolution = 0.5F * coarse_edge;
  grid.frame.size = {41, 20, 30};
  grid.states.assign(grid.frame.voxels(), VoxelState::never_seen);
  return grid;
}

SurfaceSamples random_points(std::mt19937& random, float centre_x) {
  std::uniform_real_distribution<float> any(-0.03F, 0.03F);
  Points points(20, 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    points.row(i) << centre_x + any(random), any(random), 0.15F + any(random);
  return surface_samples(points);
}

/// The owner of the nearest point, as measured between coarse voxels; the first of several.
int nearest_owner(const std::vector<SurfaceSamples>& objects, const OccupancyGrid& grid,
                  const Eigen::Vector3f& point, int radius) {
  const auto coarse = [&](const Eigen::Vector3f& p) -> Eigen::Vector3i {
    return ((p - grid.frame.origin) / coarse_edge).array().floor().cast<int>();
  };
  int owner = -1, least = radius * radius + 1;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    for (Eigen::Index k = 0; k < objects[i].size(); ++k) {
      const int squared =
          (coarse(objects[i].positions.row(k).transpose()) - coarse(point)).squaredNorm();
      if (squared < least) owner = static_cast<int>(i);
      least = std::min(least, squared);
    }
  }
  return owner;
}

TEST(UnknownSpace, BelongsToTheNearestObjectWithinReach) {
  std::mt19937 random(5);
  const OccupancyGrid grid = never_seen();
  const std::vector<SurfaceSamples> objects{random_points(random, -0.05F),
                                            random_points(random, 0.08F)};
  const UnknownSpace space(grid, objects, SurfaceSamples{}, 3.5F * coarse_edge);
  std::uniform_real_distribution<float> share(0.0F, 1.0F);
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Array3f at = Eigen::Array3f::NullaryExpr([&] { return share(random); });
    const Eigen::Vector3f point =
        grid.frame.origin +
        (at * grid.frame.size.array().cast<float>()).matrix() * grid.frame.resolution;
    const int owner = nearest_owner(objects, grid, point, 3);
    for (const int object : {0, 1}) EXPECT_EQ(space.blocks(point, object), owner != object);
  }
}

TEST(UnknownSpace, BlocksOutsideTheGridAndWhereNothingIsNear) {
  const OccupancyGrid grid = never_seen();
  const UnknownSpace space(grid, {SurfaceSamples{}}, SurfaceSamples{}, 0.05F);
  EXPECT_TRUE(space.blocks({0.0F, 0.0F, 0.1F}, 0));
  EXPECT_TRUE(space.blocks({0.0F, 0.0F, 1.0F}, 0));
}

}  // namespace
}  // namespace symscene
