// Planes of edge curves, and the stages before them, move and scale with the cloud.
#include <gtest/gtest.h>

#include <algorithm>

#include "segmentation/workspace.hpp"
#include "similarity.hpp"
#include "surfaces.hpp"
#include "symscene/segmentation/supervoxels.hpp"
#include "symscene/symmetry/curve_detection.hpp"

namespace symscene::testing {
namespace {

PointCloud seen_carton() { return seen_from(box({0.1, 0.16, 0.22}), {1.0F, 0.8F, 1.0F}); }

NeighborLists neighbors_at(const PointCloud& cloud, double scale) {
  return voxel_neighbors(cloud.positions, 0.005 * scale);
}

std::vector<EdgeCurve> curves_at(const PointCloud& cloud, double scale = 1.0) {
  const NeighborLists neighbors = neighbors_at(cloud, scale);
  const Partition partition = facets(cloud, neighbors, scaled_lengths(SupervoxelOptions{}, scale));
  return edge_curves(cloud, neighbors, partition.labels, scaled_lengths(EdgeCurveOptions{}, scale));
}

std::vector<ReflectionPlane> planes_of_curves(const PointCloud& cloud, const DistanceField& field,
                                              double scale = 1.0) {
  return planes_of(detect_reflectional_by_curves(cloud, curves_at(cloud, scale), field,
                                                 scaled_lengths(CurveDetectionOptions{}, scale))
                       .candidates);
}

TEST(PlanesOfCurves, OfAScaledSurfaceAreTheScaledOnes) {
  for (const PointCloud& cloud : {box({0.1, 0.16, 0.22}), seen_carton()}) {
    const std::vector<ReflectionPlane> here = planes_of_curves(cloud, nothing_known(cloud));
    ASSERT_GE(here.size(), 3U);
    for (const double scale : scales) {
      const PointCloud scaled = scaling_by(scale)(cloud);
      EXPECT_TRUE(are_the_same(planes_of_curves(scaled, nothing_known(scaled, scale), scale),
                               scaling_by(scale)(here), centroid(scaled.positions), rounding,
                               rounding * scale))
          << "scale " << scale << ", " << cloud.size() << " points";
    }
  }
}

TEST(PlanesOfCurves, InFreeSpaceOfAScaledSurfaceAreTheScaledOnes) {
  const PointCloud cloud = seen_carton();
  const std::vector<ReflectionPlane> here = planes_of_curves(cloud, all_seen(cloud));
  for (const double scale : scales) {
    const PointCloud scaled = scaling_by(scale)(cloud);
    EXPECT_TRUE(are_the_same(planes_of_curves(scaled, all_seen(scaled, scale), scale),
                             scaling_by(scale)(here), centroid(scaled.positions), rounding,
                             rounding * scale))
        << "scale " << scale;
  }
}

/// The share of planes that one of the others is, within 2° and 3 mm at `here`.
double share_repeated(const std::vector<ReflectionPlane>& planes,
                      const std::vector<ReflectionPlane>& others, const Eigen::Vector3d& here) {
  const SameSymmetry same{here, radians(2.0), 0.003};
  double repeated = 0.0;
  for (const ReflectionPlane& plane : planes) {
    repeated += std::any_of(others.begin(), others.end(),
                            [&](const ReflectionPlane& other) { return same(plane, other); })
                    ? 1.0
                    : 0.0;
  }
  return repeated / static_cast<double>(planes.size());
}

TEST(PlanesOfCurves, OfAMovedSurfaceAreMostOfTheMovedOnes) {
  // Curves link points by their least distances. Rounding decides between equal ones, of which a
  // sampled box has many, so that some curves and their planes differ after a motion.
  const PointCloud cloud = seen_carton();
  const std::vector<ReflectionPlane> planes = planes_of_curves(cloud, nothing_known(cloud));
  for (std::uint32_t seed = 21; seed < 24; ++seed) {
    const Similarity moved_by = motion_of(seed);
    const PointCloud moved = moved_by(cloud);
    const std::vector<ReflectionPlane> there = planes_of_curves(moved, nothing_known(moved));
    const Eigen::Vector3d here = centroid(moved.positions);
    EXPECT_GT(share_repeated(moved_by(planes), there, here), 0.8) << "seed " << seed;
    EXPECT_GT(share_repeated(there, moved_by(planes), here), 0.8) << "seed " << seed;
  }
}

}  // namespace
}  // namespace symscene::testing
