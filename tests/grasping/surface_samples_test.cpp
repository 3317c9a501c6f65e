#include <gtest/gtest.h>

#include <random>

#include "core/surface_sampling.hpp"
#include "grasping/random_scenes.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

/// The greatest distance of a point of `a` from the nearest of `b`. [m]
float farthest(const Points& a, const Points& b) {
  constexpr float reach = 0.05F;
  const CellList cells(b, 0.01F);
  float greatest = 0.0F;
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const Index nearest = cells.nearest(a.row(i).transpose(), reach).first;
    if (nearest == CellList::none) return reach;
    greatest = std::max(greatest, (a.row(i) - b.row(nearest)).norm());
  }
  return greatest;
}

TEST(SurfaceSamples, LieWithinTheSamplingBoundOfEveryPoint) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 20; ++trial) {
    const TriangleMesh mesh = testing::random_shape(random);
    const SurfaceSamples samples = surface_samples(testing::seen_all_over(mesh).surface);
    const PointCloud surface = sample_surface(mesh, 20000);
    EXPECT_LT(farthest(surface.positions, samples.positions), testing::sampling_bound) << trial;
  }
}

TEST(SurfaceSamples, LieOnTheSurface) {
  std::mt19937 random(12);
  // What 20,000 points leave of the largest shape.
  constexpr double spacing = 0.0025;
  for (int trial = 0; trial < 20; ++trial) {
    const TriangleMesh mesh = testing::random_shape(random);
    const SurfaceSamples samples = surface_samples(testing::seen_all_over(mesh).surface);
    const PointCloud surface = sample_surface(mesh, 20000);
    EXPECT_LT(farthest(samples.positions, surface.positions), testing::sample_offset + spacing)
        << trial;
  }
}

}  // namespace
}  // namespace symscene
