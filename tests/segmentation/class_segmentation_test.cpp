#include "segmentation/class_segmentation.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"
#include "symscene/core/error.hpp"
#include "symscene/segmentation/surface_graph.hpp"

namespace symscene {
namespace {

const std::vector<ObjectAxis> no_axes;
const Eigen::Vector3d box_size{0.1, 0.12, 0.16};

/// A box without its base, as a camera sees one that stands.
PointCloud standing_box() {
  const PointCloud whole = testing::box(box_size);
  PointIndices seen;
  for (Index i = 0; i < whole.size(); ++i) {
    if (whole.normals(i, 2) > -0.5F) seen.push_back(i);
  }
  return select(whole, seen);
}

/// Such a box and a vase close to it.
struct BoxAndVase {
  PointCloud box_cloud = standing_box();
  PointCloud cloud = testing::joined(
      box_cloud,
      testing::moved(testing::vase(), Eigen::Isometry3d(Eigen::Translation3d(0.13, 0.0, 0.0))));

  PointIndices whole_box() const {
    PointIndices points(box_cloud.size());
    for (Index i = 0; i < box_cloud.size(); ++i) points[i] = i;
    return points;
  }
  /// The points of the box above a height.
  PointIndices box_above(float height) const {
    PointIndices points;
    for (const Index i : whole_box()) {
      if (cloud.position(i).z() > height) points.push_back(i);
    }
    return points;
  }
  std::vector<std::optional<ClassHypothesis>> cut(
      const std::vector<ClassSeed>& seeds, const ClassSegmentationOptions& options = {}) const {
    const std::vector<WeightedEdge> edges = surface_graph(cloud);
    const DistanceField field = testing::nothing_known(cloud);
    return segment_classes({cloud, edges, field}, 0.005, seeds, {}, options);
  }
};

TEST(SegmentClasses, ABoxIsCutOutByTheSurfaceOfAPartOfIt) {
  const BoxAndVase scene;
  const PointIndices seed = scene.box_above(0.05F);
  const auto found = scene.cut({{seed, no_axes}});
  ASSERT_EQ(found.size(), 1U);
  ASSERT_TRUE(found[0]);
  EXPECT_EQ(found[0]->symmetry_class.kind, SymmetryClass::box);
  EXPECT_LT(intersection_over_union(seed, scene.whole_box()), 0.75);
  EXPECT_GT(intersection_over_union(found[0]->points, scene.whole_box()), 0.97);
}

TEST(SegmentClasses, AShapeThatNoSurfaceExplainsHasNoHypothesis) {
  const BoxAndVase scene;
  PointIndices vase;
  for (Index i = scene.box_cloud.size(); i < scene.cloud.size(); ++i) vase.push_back(i);
  const auto found = scene.cut({{vase, no_axes}});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0]);
}

TEST(SegmentClasses, HypothesesAreInTheOrderOfTheirSeedsAndMoveWithTheScene) {
  BoxAndVase scene;
  const PointIndices upper = scene.box_above(0.05F), whole = scene.whole_box();
  const auto found = scene.cut({{upper, no_axes}, {whole, no_axes}});
  Eigen::Isometry3d motion(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  motion.pretranslate(Eigen::Vector3d(0.3, -0.2, 0.1));
  scene.cloud = testing::moved(scene.cloud, motion);
  const auto moved = scene.cut({{upper, no_axes}, {whole, no_axes}});
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_TRUE(found[k] && moved[k]);
    EXPECT_GT(intersection_over_union(found[k]->points, moved[k]->points), 0.99);
  }
}

TEST(SegmentClasses, EmptyRangesAreRefused) {
  ClassSegmentationOptions options;
  options.max_angle = options.min_angle;
  EXPECT_THROW(BoxAndVase().cut({}, options), InputError);
}

}  // namespace
}  // namespace symscene
