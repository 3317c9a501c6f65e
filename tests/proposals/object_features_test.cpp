#include "proposals/object_feature_extractor.hpp"

#include <gtest/gtest.h>

#include <set>

#include "surfaces.hpp"
#include "symscene/segmentation/surface_graph.hpp"

namespace symscene {
namespace {

using testing::all_of;
using testing::joined;

PointCloud shifted(PointCloud cloud, const Eigen::Vector3f& by) {
  cloud.positions.rowwise() += by.transpose();
  return cloud;
}

/// Two cubes of 10 cm with 20 cm between them.
PointCloud two_boxes() {
  const PointCloud cube = testing::box({0.1, 0.1, 0.1});
  return joined(cube, shifted(cube, {0.3F, 0.0F, 0.0F}));
}

/// The space around cubes of 10 cm that stand at the origin and at x = 30 cm, seen empty; what is
/// inside the cubes was never seen.
DistanceField seen_around_boxes(const PointCloud& cloud) {
  OccupancyGrid grid = rasterize(OccupancyMap{}, bounding_box(cloud.positions).padded(0.1F));
  std::size_t k = 0;
  for (int z = 0; z < grid.frame.size.z(); ++z) {
    for (int y = 0; y < grid.frame.size.y(); ++y) {
      for (int x = 0; x < grid.frame.size.x(); ++x, ++k) {
        const Eigen::Vector3f p =
            grid.frame.origin +
            grid.frame.resolution *
                (Eigen::Vector3i(x, y, z).cast<float>().array() + 0.5F).matrix();
        const bool within = std::min(std::abs(p.x()), std::abs(p.x() - 0.3F)) < 0.05F &&
                            std::abs(p.y()) < 0.05F && p.z() > 0.0F && p.z() < 0.1F;
        grid.states[k] = within ? VoxelState::never_seen : VoxelState::free;
      }
    }
  }
  return distance_field(grid, std::nullopt);
}

OwnFeatures features_of(const PointCloud& cloud, const PointIndices& points,
                        const std::vector<WeightedEdge>& edges, const DistanceField& field) {
  const SurfaceRegions regions =
      smooth_regions(cloud, edges, radius_neighbors(cloud.positions, 0.00866F));
  const SurfaceRegions patches = patch_regions(cloud, edges);
  const ProposalOptions options;
  return ObjectFeatureExtractor({cloud, edges, field, regions, patches}, options)
      .features({points, {}, {}, 0.0});
}

OwnFeatures features_of(const PointCloud& cloud, const PointIndices& points,
                        const DistanceField& field) {
  return features_of(cloud, points, surface_graph(cloud), field);
}

TEST(ObjectFeatures, HaveAsManyValuesAsNamesInTheirOrder) {
  ObjectFeatures features;
  std::set<std::string> names;
  double next = 0.0;
  ObjectFeatures::visit_fields(features, [&](const char* name, double& value) {
    names.insert(name);
    value = next;
    next += 1.0;
  });
  EXPECT_EQ(names.size(), static_cast<std::size_t>(next));
  std::vector<double> values;
  ObjectFeatures::visit_fields(features,
                               [&](const char*, double value) { values.push_back(value); });
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_EQ(values.at(k), static_cast<double>(k));
  EXPECT_EQ(features.broken, 0.0);
  EXPECT_EQ(features.confidence, 23.0);
}

TEST(ObjectFeatureExtractor, CountsTheEdgesThatLeaveAndBend) {
  // A flat row: from {0, 1}, the edge to 2 leaves smoothly and that to 3 is a crease.
  PointCloud cloud;
  cloud.positions.resize(4, 3);
  cloud.positions << 0.0F, 0.0F, 0.0F, 0.005F, 0.0F, 0.0F, 0.01F, 0.0F, 0.0F, 0.0F, 0.005F, 0.0F;
  cloud.normals = Points::Zero(4, 3);
  cloud.normals.col(2).setOnes();
  const std::vector<WeightedEdge> edges{{0, 1, 0.75F}, {1, 2, 0.5F}, {0, 3, 0.25F}};
  const DistanceField field = testing::nothing_known(cloud);
  const OwnFeatures features = features_of(cloud, {0, 1}, edges, field);
  EXPECT_DOUBLE_EQ(features.broken, 0.75 / std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(features.rim, 2.0 / std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(features.torn, 0.5);
  EXPECT_DOUBLE_EQ(features.bend, 0.25);
  EXPECT_DOUBLE_EQ(features.crease, 0.0);
  EXPECT_DOUBLE_EQ(features.unity, 1.0);
  EXPECT_DOUBLE_EQ(features.near_others, 1.0);

  const OwnFeatures apart = features_of(cloud, {2, 3}, edges, field);
  EXPECT_DOUBLE_EQ(apart.unity, 0.5);
  EXPECT_DOUBLE_EQ(apart.bend, 0.0);

  const OwnFeatures all = features_of(cloud, {0, 1, 2, 3}, edges, field);
  EXPECT_DOUBLE_EQ(all.broken, 0.0);
  EXPECT_DOUBLE_EQ(all.torn, 0.0);
  EXPECT_DOUBLE_EQ(all.bend, (0.25 + 0.5 + 0.75) / 3.0);
  EXPECT_DOUBLE_EQ(all.crease, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(all.near_others, 0.0);
}

TEST(ObjectFeatureExtractor, CountsPointsThatFaceEachOtherAsNotConvex) {
  PointCloud cloud;
  cloud.positions.resize(2, 3);
  cloud.positions << 0.0F, 0.0F, 0.0F, 0.1F, 0.0F, 0.0F;
  cloud.normals.resize(2, 3);
  cloud.normals << -1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F;
  EXPECT_EQ(features_of(cloud, {0, 1}, testing::nothing_known(cloud)).convexity, 1.0);
  cloud.normals *= -1.0F;
  EXPECT_EQ(features_of(cloud, {0, 1}, testing::nothing_known(cloud)).convexity, 0.0);
  EXPECT_EQ(features_of(cloud, {0}, testing::nothing_known(cloud)).convexity, 1.0);
}

TEST(ObjectFeatureExtractor, OfOneBoxIsConvexAndOfTwoIsNotAndIsEmptyBetween) {
  const PointCloud cloud = two_boxes();
  const DistanceField field = seen_around_boxes(cloud);
  PointIndices first = all_of(cloud);
  first.resize(cloud.size() / 2);
  const OwnFeatures one = features_of(cloud, first, field);
  const OwnFeatures two = features_of(cloud, all_of(cloud), field);
  EXPECT_GT(one.convexity, 0.98);
  EXPECT_LT(two.convexity, one.convexity - 0.1);
  EXPECT_LT(one.empty, 0.02);
  EXPECT_GT(two.empty, 0.3);
  EXPECT_EQ(one.unity, 1.0);
  EXPECT_EQ(two.unity, 0.5);
  EXPECT_EQ(one.near_others, 0.0);
  EXPECT_EQ(features_of(cloud, all_of(cloud), testing::nothing_known(cloud)).empty, 0.0);
}

TEST(ObjectFeatureExtractor, MeasuresExtentsByTheLongest) {
  const PointCloud cloud = testing::box({0.1, 0.16, 0.23});
  const DistanceField field = testing::nothing_known(cloud);
  const OwnFeatures loose = features_of(cloud, all_of(cloud), field);
  EXPECT_NEAR(loose.width_ratio, 0.16 / 0.23, 0.02);
  EXPECT_NEAR(loose.thickness_ratio, 0.1 / 0.23, 0.02);
}

TEST(ObjectFeatureExtractor, FillsEveryFeatureOfAnObjectWithSymmetries) {
  const PointCloud cloud = two_boxes();
  const std::vector<WeightedEdge> edges = surface_graph(cloud);
  const SurfaceRegions regions =
      smooth_regions(cloud, edges, radius_neighbors(cloud.positions, 0.00866F));
  const SurfaceRegions patches = patch_regions(cloud, edges);
  const DistanceField field = seen_around_boxes(cloud);
  const ProposalOptions options;
  MergedHypothesis box{all_of(cloud), {}, {}, 0.7};
  box.points.resize(cloud.size() / 2);
  box.planes = {{{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}, 0.0},
                {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY()}, 0.0}};
  const ObjectFeatureExtractor extractor({cloud, edges, field, regions, patches}, options);
  const OwnFeatures features = extractor.features(box);
  EXPECT_EQ(features.confidence, 0.7);
  EXPECT_EQ(features.axes, 0.0);
  EXPECT_EQ(features.axis_misfit, 1.0);
  EXPECT_EQ(features.planes, 2.0);
  EXPECT_GT(features.plane_inlier, 0.8);
  EXPECT_LT(features.plane_occlusion, 0.05);
  EXPECT_EQ(features.seam, regions.seam(box.points));
  EXPECT_EQ(features.fold, patches.seam(box.points));
  EXPECT_EQ(features.fold_rim, patches.rim(box.points));
  EXPECT_EQ(features.near_unity, patches.unity(box.points));
}

}  // namespace
}  // namespace symscene
