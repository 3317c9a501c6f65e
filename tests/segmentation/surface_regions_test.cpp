#include "segmentation/surface_regions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <set>

#include "surfaces.hpp"
#include "symscene/core/error.hpp"
#include "symscene/segmentation/surface_graph.hpp"

namespace symscene {
namespace {

SurfaceRegions regions_of(const PointCloud& cloud, const SurfacePartsOptions& options = {}) {
  return smooth_regions(cloud, surface_graph(cloud), radius_neighbors(cloud.positions, 0.00866F),
                        options);
}

/// A cube of 10 cm and a smaller one that stands against its face at x = 5 cm; none of the points
/// where they touch, which no camera sees.
struct TouchingBoxes {
  PointCloud cloud;
  PointIndices large, small;

  TouchingBoxes() {
    const PointCloud cube = testing::box({0.1, 0.1, 0.1});
    PointIndices seen;
    for (Index i = 0; i < cube.size(); ++i) {
      const Eigen::Vector3f p = cube.position(i);
      const bool touches = cube.normal(i).x() > 0.9F && std::abs(p.y()) < 0.031F && p.z() < 0.061F;
      if (!touches) seen.push_back(i);
    }
    PointCloud other = testing::box({0.06, 0.06, 0.06});
    other.positions.col(0).array() += 0.08F;
    PointIndices other_seen;
    for (Index i = 0; i < other.size(); ++i) {
      if (other.normal(i).x() > -0.9F) other_seen.push_back(i);
    }
    const PointCloud a = select(cube, seen), b = select(other, other_seen);
    cloud = testing::joined(a, b);
    for (Index i = 0; i < cloud.size(); ++i) (i < a.size() ? large : small).push_back(i);
  }
};

double best_overlap(const std::vector<PointIndices>& parts, const PointIndices& points) {
  double best = 0.0;
  for (const PointIndices& part : parts)
    best = std::max(best, intersection_over_union(part, points));
  return best;
}

PointIndices face(const PointCloud& cloud, const Eigen::Vector3f& normal) {
  PointIndices points;
  for (Index i = 0; i < cloud.size(); ++i) {
    if (cloud.normal(i).dot(normal) > 0.99F) points.push_back(i);
  }
  return points;
}

TEST(SurfaceParts, OfTwoTouchingBoxesAreEachOfThem) {
  const TouchingBoxes scene;
  const std::vector<PointIndices> parts = regions_of(scene.cloud).parts();
  EXPECT_GT(best_overlap(parts, scene.large), 0.95);
  EXPECT_GT(best_overlap(parts, scene.small), 0.95);
  EXPECT_EQ(best_overlap(parts, testing::all_of(scene.cloud)), 1.0);
}

TEST(SurfaceParts, OfABoxAreItsFacesAndItAtTheTop) {
  const PointCloud cube = testing::box({0.1, 0.12, 0.14});
  const std::vector<PointIndices> parts = regions_of(cube).parts();
  ASSERT_FALSE(parts.empty());
  EXPECT_EQ(parts.back(), testing::all_of(cube));
  EXPECT_GT(best_overlap(parts, face(cube, Eigen::Vector3f::UnitX())), 0.9);
  EXPECT_GT(best_overlap(parts, face(cube, -Eigen::Vector3f::UnitY())), 0.9);
}

TEST(SurfaceParts, AreAscendingDistinctAndNotTooSmall) {
  const TouchingBoxes scene;
  const SurfacePartsOptions options;
  const std::vector<PointIndices> parts = regions_of(scene.cloud, options).parts();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    EXPECT_GE(parts[k].size(), static_cast<std::size_t>(options.min_size));
    EXPECT_TRUE(std::is_sorted(parts[k].begin(), parts[k].end()));
    EXPECT_EQ(std::adjacent_find(parts[k].begin(), parts[k].end()), parts[k].end());
    for (std::size_t other = 0; other < k; ++other) EXPECT_NE(parts[k], parts[other]);
  }
}

TEST(SurfaceParts, AreATree) {
  // Two parts share all points of the smaller one or none.
  const TouchingBoxes scene;
  const std::vector<PointIndices> parts = regions_of(scene.cloud).parts();
  for (const PointIndices& a : parts) {
    for (const PointIndices& b : parts) {
      const std::size_t common = intersection_size(a, b);
      EXPECT_TRUE(common == 0 || common == std::min(a.size(), b.size()));
    }
  }
}

TEST(SurfaceParts, LeaveOutWhatIsBelowTheLeastSize) {
  const PointCloud cube = testing::box({0.1, 0.1, 0.1});
  SurfacePartsOptions options;
  options.min_size = static_cast<int>(cube.size());
  EXPECT_EQ(regions_of(cube, options).parts().size(), 1U);
  ++options.min_size;
  EXPECT_TRUE(regions_of(cube, options).parts().empty());
}

TEST(Seam, IsNothingOnAFaceAndLargeAcrossTouchingBoxes) {
  const TouchingBoxes scene;
  const SurfaceRegions regions = regions_of(scene.cloud);
  EXPECT_LT(regions.seam(face(scene.cloud, Eigen::Vector3f::UnitY())), 0.05);
  const double within = regions.seam(scene.large);
  const double across = regions.seam(testing::all_of(scene.cloud));
  // A convex right angle weakens an edge by 1 − exp(−1/2) = 0.39, a concave one by 1 −
  // exp(−1/0.15).
  EXPECT_LT(within, 0.4);
  EXPECT_GT(across, 0.8);
}

TEST(Seam, BetweenTwoPatchesIsTheMeanWeaknessOfTheirEdges) {
  // A floor and a wall of 10 × 10 points, 5 mm apart, that only the edges given here join.
  constexpr Index side = 10, patch = side * side;
  PointCloud cloud;
  cloud.positions.resize(2 * patch, 3);
  cloud.normals.resize(2 * patch, 3);
  for (Index i = 0; i < side; ++i) {
    for (Index j = 0; j < side; ++j) {
      const float u = 0.005F * static_cast<float>(i + 1), v = 0.005F * static_cast<float>(j);
      cloud.positions.row(i * side + j) << u, v, 0.0F;
      cloud.normals.row(i * side + j) << 0.0F, 0.0F, 1.0F;
      cloud.positions.row(patch + i * side + j) << 0.0F, v, u;
      cloud.normals.row(patch + i * side + j) << 1.0F, 0.0F, 0.0F;
    }
  }
  const std::vector<WeightedEdge> edges{{0, 1, 0.5F}, {0, patch, 0.125F}, {1, patch + 1, 0.375F}};
  const SurfaceRegions regions =
      smooth_regions(cloud, edges, radius_neighbors(cloud.positions, 0.0071F));
  EXPECT_EQ(regions.parts().size(), 3U);
  EXPECT_DOUBLE_EQ(regions.seam(testing::all_of(cloud)), 0.75);
  // The floor alone, with a few points of the wall: the wall is not of the set.
  PointIndices floor = testing::all_of(cloud);
  floor.resize(patch + 5);
  EXPECT_DOUBLE_EQ(regions.seam(floor), 0.0);
}

TEST(PatchRegions, OfTwoTouchingBoxesPartAtTheFold) {
  const TouchingBoxes scene;
  const SurfaceRegions patches = patch_regions(scene.cloud, surface_graph(scene.cloud));
  const std::vector<PointIndices> parts = patches.parts_at(std::array{0.3});
  EXPECT_GT(best_overlap(parts, scene.large), 0.9);
  EXPECT_GT(best_overlap(parts, scene.small), 0.9);
  EXPECT_LT(best_overlap(parts, testing::all_of(scene.cloud)), 0.9);
  EXPECT_EQ(best_overlap(patches.parts_at(std::array{1.0}), testing::all_of(scene.cloud)), 1.0);
  EXPECT_LT(patches.seam(scene.large), 0.2);
  EXPECT_GT(patches.seam(testing::all_of(scene.cloud)), 0.5);
  // Nothing lies around both; the border of one is the fold to the other.
  EXPECT_EQ(patches.rim(testing::all_of(scene.cloud)), 1.0);
  EXPECT_GT(patches.rim(scene.small), 0.5);
  EXPECT_LT(patches.rim(face(scene.cloud, Eigen::Vector3f::UnitY())), 0.2);
}

TEST(PatchRegions, AreOneAcrossASmallGapAndTwoAcrossALargeOne) {
  const PointCloud cube = testing::box({0.06, 0.06, 0.06});
  for (const auto& [gap, unity] : {std::pair{0.01F, 1.0}, std::pair{0.1F, 0.5}}) {
    PointCloud other = cube;
    other.positions.col(0).array() += 0.06F + gap;
    const PointCloud both = testing::joined(cube, other);
    const SurfaceRegions patches = patch_regions(both, surface_graph(both));
    EXPECT_NEAR(patches.unity(testing::all_of(both)), unity, 0.01);
  }
}

TEST(PatchRegions, ArePartedAtEveryScaleBelowTheWhole) {
  const TouchingBoxes scene;
  const SurfaceRegions regions = regions_of(scene.cloud);
  std::set<PointIndices> all;
  for (PointIndices& part : regions.parts()) all.insert(std::move(part));
  for (const PointIndices& part : regions.parts_at(std::array{0.05, 0.3, 0.6}))
    EXPECT_TRUE(all.contains(part));
}

TEST(SurfacePartsOptions, OutOfRangeAreRefused) {
  const PointCloud cube = testing::box({0.05, 0.05, 0.05});
  for (const auto& spoil : std::vector<std::function<void(SurfacePartsOptions&)>>{
           [](auto& o) { o.smooth_angle = 0.0; }, [](auto& o) { o.smooth_angle = 3.2; },
           [](auto& o) { o.smooth_angle = std::numeric_limits<double>::quiet_NaN(); },
           [](auto& o) { o.fragment = -1; }, [](auto& o) { o.min_size = 0; },
           [](auto& o) { o.min_seam_share = -0.1; }, [](auto& o) { o.min_seam_share = 0.6; }}) {
    SurfacePartsOptions options;
    spoil(options);
    EXPECT_THROW(regions_of(cube, options), InputError);
  }
}

}  // namespace
}  // namespace symscene
