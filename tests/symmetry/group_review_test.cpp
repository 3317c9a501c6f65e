#include "symscene/symmetry/group_review.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"

namespace symscene {
namespace {

SymmetryGroup group_of(const TriangleMesh& mesh) {
  SymmetryGroupOptions options;
#ifdef SYMSCENE_SANITIZED
  options.directions = 600;
  options.coarse_points = 60;
  options.fit_points = 100;
  options.residual_points = 200;
#endif
  return find_symmetry_group(sample_surface(mesh, 12000), options);
}

SymmetryGroup box_group() { return group_of(make_box({0.1, 0.16, 0.23}, 0.02)); }

SymmetryGroup can_group() {
  const std::vector<ProfilePoint> profile{{0.0, 0.0}, {0.04, 0.0}, {0.04, 0.12}, {0.0, 0.12}};
  return group_of(make_revolution(profile, 64, 0.01));
}

std::vector<bool> only(std::size_t k, std::size_t count) {
  std::vector<bool> flags(count, false);
  flags[k] = true;
  return flags;
}

bool turns_about(const Eigen::Isometry3d& rotation, const RotationAxis& axis) {
  return (rotation.linear() * axis.direction - axis.direction).norm() < 0.1;
}

void expect_closed(const SymmetryGroup& group) {
  std::vector<Eigen::Isometry3d> all = group.rotations;
  all.push_back(Eigen::Isometry3d::Identity());
  for (const Eigen::Isometry3d& a : all) {
    for (const Eigen::Isometry3d& b : all) {
      const Eigen::Matrix4d product = (a * b).matrix();
      EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Eigen::Isometry3d& other) {
        return (product - other.matrix()).norm() < 1e-9;
      }));
    }
  }
}

TEST(GroupReview, LeavesHalfTurnsAndPlanesOfASquareBarWhoseQuarterTurnIsRejected) {
  const SymmetryGroup bar = group_of(make_box({0.1, 0.1, 0.25}, 0.02));
  ASSERT_EQ(bar.rotations.size(), 7U);
  ASSERT_EQ(bar.planes.size(), 5U);
  RejectedSymmetries rejected;
  rejected.axes.assign(bar.axes.size(), false);
  rejected.planes.assign(bar.planes.size(), false);
  const auto is_diagonal = [](const Eigen::Vector3d& direction) {
    return direction.cwiseAbs().maxCoeff() < 0.9;
  };
  for (std::size_t k = 0; k < bar.axes.size(); ++k)
    rejected.axes[k] = bar.axes[k].order == 4 || is_diagonal(bar.axes[k].axis.direction);
  for (std::size_t k = 0; k < bar.planes.size(); ++k)
    rejected.planes[k] = is_diagonal(bar.planes[k].plane.normal);
  const RemainingGroup left = without(bar, rejected);
  EXPECT_EQ(left.group.rotations.size(), 3U);
  EXPECT_EQ(left.group.planes.size(), 3U);
  ASSERT_EQ(left.group.axes.size(), 3U);
  for (const GroupAxis& axis : left.group.axes) EXPECT_EQ(axis.order, 2);
  expect_closed(left.group);
}

TEST(GroupReview, KeepsWhatIsAccepted) {
  for (const SymmetryGroup& group : {box_group(), can_group()}) {
    const RemainingGroup kept = without(group, {});
    EXPECT_EQ(kept.group.axes.size(), group.axes.size());
    EXPECT_EQ(kept.group.planes.size(), group.planes.size());
    EXPECT_EQ(kept.group.rotations.size(), group.rotations.size());
    EXPECT_TRUE(kept.implied_axes.empty());
    EXPECT_TRUE(kept.implied_planes.empty());
  }
}

TEST(GroupReview, NeverMakesARejectedTurnAndStaysClosed) {
  const SymmetryGroup group = box_group();
  ASSERT_EQ(group.axes.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const RemainingGroup remaining = without(group, {false, only(k, 3), {}});
    // Two half turns of a box make the third; two of its planes the one about their line.
    EXPECT_EQ(remaining.group.axes.size(), 1U);
    EXPECT_EQ(remaining.implied_axes.size(), 1U);
    EXPECT_GE(remaining.implied_planes.size(), 1U);
    EXPECT_EQ(remaining.group.rotations.size(), 1U);
    for (const Eigen::Isometry3d& rotation : remaining.group.rotations)
      EXPECT_FALSE(turns_about(rotation, group.axes[k].axis));
    expect_closed(remaining.group);
  }
}

TEST(GroupReview, WithAllPlanesRejectedTheTurnsRemain) {
  const SymmetryGroup group = box_group();
  const RemainingGroup remaining = without(group, {false, {}, {true, true, true}});
  EXPECT_TRUE(remaining.group.planes.empty());
  EXPECT_EQ(remaining.group.axes.size(), 3U);
  EXPECT_EQ(remaining.group.rotations.size(), 3U);
}

TEST(GroupReview, OfASurfaceOfRevolutionFlipAndPlaneGoTogether) {
  const SymmetryGroup group = can_group();
  ASSERT_EQ(group.axes.size(), 2U);
  ASSERT_EQ(group.planes.size(), 1U);
  const RemainingGroup without_plane = without(group, {false, {}, {true}});
  ASSERT_EQ(without_plane.group.axes.size(), 1U);
  EXPECT_EQ(without_plane.group.axes.front().order, GroupAxis::continuous);
  EXPECT_EQ(without_plane.implied_axes, std::vector<std::size_t>{1});
  EXPECT_TRUE(without_plane.group.rotations.empty());

  const RemainingGroup without_axis = without(group, {false, {true}, {}});
  EXPECT_TRUE(without_axis.group.axes.empty());
  EXPECT_EQ(without_axis.group.planes.size(), 1U);
  EXPECT_TRUE(without_axis.group.rotations.empty());
}

TEST(GroupReview, ARejectedSphereIsNone) {
  SymmetryGroup group;
  group.sphere = true;
  EXPECT_FALSE(without(group, {true, {}, {}}).group.sphere);
  EXPECT_TRUE(without(group, {}).group.sphere);
}

}  // namespace
}  // namespace symscene
