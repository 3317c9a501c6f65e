#include <gtest/gtest.h>

#include "surfaces.hpp"
#include "symscene/segmentation/reflectional_segmentation.hpp"
#include "symscene/segmentation/rotational_segmentation.hpp"
#include "symscene/segmentation/surface_graph.hpp"

namespace symscene {
namespace {

using testing::all_seen;
using testing::box;
using testing::joined;
using testing::vase;

PointCloud shifted(const PointCloud& cloud, const Eigen::Vector3d& by) {
  return testing::moved(cloud, Eigen::Isometry3d(Eigen::Translation3d(by)));
}

/// The indices of `count` points from `first` on.
PointIndices range(Index first, Index count) {
  PointIndices indices(count);
  for (Index i = 0; i < count; ++i) indices[i] = first + i;
  return indices;
}

std::vector<Hypothesis> hypotheses_about_z(const PointCloud& cloud,
                                           const RotationalSegmentationOptions& options = {}) {
  RotationalCandidate candidate;
  candidate.axis = {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()};
  return segment_rotational({cloud, surface_graph(cloud), all_seen(cloud)}, {candidate}, {},
                            options);
}

/// A box about the z axis and a vase beside it, which the plane y = 0 mirrors too.
struct BoxBesideVase {
  Eigen::Vector3d size{0.1, 0.12, 0.16};
  Index box_size = box(size).size();
  PointCloud cloud = joined(box(size), shifted(vase(), {0.25, 0.0, 0.0}));

  /// The face of the box at x = 5 cm.
  PointIndices face() const {
    PointIndices points;
    for (Index i = 0; i < box_size; ++i) {
      if (cloud.normals(i, 0) > 0.9F) points.push_back(i);
    }
    return points;
  }

  SegmentedHypotheses cut(const ReflectionPlane& plane,
                          const ReflectionalSegmentationOptions& options = {}) const {
    return segment_reflectional({cloud, surface_graph(cloud), all_seen(cloud)},
                                {{plane, {}, face()}}, {}, options);
  }
};

const ReflectionPlane mirror_of_the_box{Eigen::Vector3d(0.0, 0.0, 0.08), Eigen::Vector3d::UnitY()};

TEST(SegmentRotational, CutsTheVaseOutAndNotTheBoxBesideIt) {
  const PointCloud alone = vase();
  const PointCloud cloud = joined(alone, shifted(box({0.1, 0.1, 0.1}), {0.2, 0.0, 0.0}));
  const std::vector<Hypothesis> hypotheses = hypotheses_about_z(cloud);
  ASSERT_EQ(hypotheses.size(), 1U);
  const Hypothesis& found = hypotheses[0];
  EXPECT_GT(intersection_over_union(found.points, range(0, alone.size())), 0.95);
  EXPECT_EQ(intersection_size(found.points, range(alone.size(), cloud.size() - alone.size())), 0U);
  ASSERT_TRUE(found.axis);
  EXPECT_FALSE(found.plane);
  EXPECT_LT(line_angle(found.axis->direction, Eigen::Vector3d::UnitZ()), radians(0.5));
}

TEST(SegmentRotational, DropsComponentsFarSmallerThanTheLargest) {
  const PointCloud alone = vase();
  const std::array<ProfilePoint, 4> profile{
      ProfilePoint{0.0, 0.0}, {0.012, 0.0}, {0.012, 0.02}, {0.0, 0.02}};
  const PointCloud button =
      shifted(testing::as_cloud(make_revolution(profile, 96, 0.005)), {0.0, 0.0, 0.25});
  const PointIndices of_button = range(alone.size(), button.size());
  const PointCloud cloud = joined(alone, button);

  RotationalSegmentationOptions options;
  const std::vector<Hypothesis> dropped = hypotheses_about_z(cloud, options);
  ASSERT_EQ(dropped.size(), 1U);
  EXPECT_EQ(intersection_size(dropped[0].points, of_button), 0U);
  options.min_component = 0.0;
  const std::vector<Hypothesis> kept = hypotheses_about_z(cloud, options);
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_GT(intersection_size(kept[0].points, of_button), button.size() * 9 / 10);
}

TEST(Judge, NamesTheBoundThatAHypothesisBreaks) {
  Hypothesis hypothesis;
  hypothesis.points = range(0, 150);
  hypothesis.residuals = {0.02, 0.01, 0.1};
  EXPECT_FALSE(judge(hypothesis, {0.03, 0.015, 0.3, 150}, "rotational"));
  const auto few = judge(hypothesis, {0.03, 0.015, 0.3, 151}, "rotational");
  ASSERT_TRUE(few);
  EXPECT_EQ(few->kind, "rotational");
  EXPECT_EQ(few->reason, "size");
  EXPECT_EQ(few->value, 150.0);
  EXPECT_EQ(few->bound, 151.0);
  const auto bent = judge(hypothesis, {0.02, 0.015, 0.3, 150}, "rotational");
  ASSERT_TRUE(bent);
  EXPECT_EQ(bent->reason, "symmetry");
  const auto seen_through = judge(hypothesis, {0.03, 0.005, 0.3, 150}, "reflectional");
  ASSERT_TRUE(seen_through);
  EXPECT_EQ(seen_through->reason, "occlusion");
  const auto torn = judge(hypothesis, {0.03, 0.015, 0.05, 150}, "reflectional");
  ASSERT_TRUE(torn);
  EXPECT_EQ(torn->reason, "smoothness");
}

TEST(SegmentReflectional, CutsTheBoxOutThatHoldsTheFace) {
  const BoxBesideVase scene;
  const SegmentedHypotheses segmented = scene.cut(mirror_of_the_box);
  ASSERT_EQ(segmented.hypotheses.size(), 1U);
  EXPECT_TRUE(segmented.rejected.empty());
  const Hypothesis& found = segmented.hypotheses[0];
  EXPECT_EQ(intersection_size(found.points, scene.face()), scene.face().size());
  EXPECT_GT(intersection_over_union(found.points, range(0, scene.box_size)), 0.95);
  ASSERT_TRUE(found.plane);
  EXPECT_FALSE(found.axis);
  EXPECT_LT(line_angle(found.plane->normal, mirror_of_the_box.normal), radians(0.5));
}

TEST(SegmentReflectional, RejectsAPlaneThatItsSupportContradicts) {
  const ReflectionPlane off_centre{Eigen::Vector3d(0.025, 0.0, 0.0), Eigen::Vector3d::UnitX()};
  const SegmentedHypotheses segmented = BoxBesideVase{}.cut(off_centre);
  EXPECT_TRUE(segmented.hypotheses.empty());
  ASSERT_EQ(segmented.rejected.size(), 1U);
  EXPECT_EQ(segmented.rejected[0].kind, "reflectional");
  EXPECT_EQ(segmented.rejected[0].reason, "support");
  EXPECT_EQ(segmented.rejected[0].bound, ReflectionalSegmentationOptions{}.min_support_share);
}

}  // namespace
}  // namespace symscene
