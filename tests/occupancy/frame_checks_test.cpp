#include "occupancy/frame_checks.hpp"

#include <gtest/gtest.h>

#include "similarity.hpp"
#include "surfaces.hpp"
#include "symscene/occupancy/outward_vote.hpp"

namespace symscene {
namespace {

const Plane table{Eigen::Vector3d::UnitZ(), 0.0};
const Plane flipped{-Eigen::Vector3d::UnitZ(), 0.0};
constexpr double tolerance = 0.02;  // [m]

/// Free space above z = 0, never-seen space below.
DistanceField half_space() {
  OccupancyGrid grid = rasterize(
      OccupancyMap{}, {Eigen::Vector3f::Constant(-0.1F), Eigen::Vector3f::Constant(0.1F)});
  const std::size_t below = grid.frame.slices() / 2 * grid.frame.slice_length();
  std::fill(grid.states.begin() + static_cast<std::ptrdiff_t>(below), grid.states.end(),
            VoxelState::free);
  return distance_field(grid, std::nullopt);
}

TEST(FrameWarnings, AreNoneForAVaseOnATable) {
  const PointCloud vase = testing::vase();
  EXPECT_TRUE(frame_warnings(vase.positions, testing::all_seen(vase), table, tolerance).empty());
}

TEST(FrameWarnings, NameATableWhoseNormalPointsDown) {
  const PointCloud vase = testing::vase();
  const auto warnings = frame_warnings(vase.positions, testing::all_seen(vase), flipped, tolerance);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("below the table"), std::string::npos);
}

TEST(FrameWarnings, NameAnOccupancyMapThatIsFreeWhereMostPointsAre) {
  const DistanceField field = half_space();
  Points points = Points::Constant(10, 3, -0.05F);
  points.col(2).head(5).setConstant(0.05F);
  EXPECT_TRUE(frame_warnings(points, field, std::nullopt, tolerance).empty()) << "half of them";
  points(5, 2) = 0.05F;
  const auto warnings = frame_warnings(points, field, std::nullopt, tolerance);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("free space"), std::string::npos);
}

TEST(FrameWarnings, AreThoseOfAScaledScene) {
  const PointCloud vase = testing::vase();
  for (const double scale : testing::scales) {
    const PointCloud scaled = testing::scaling_by(scale)(vase);
    const DistanceField field = testing::all_seen(scaled, scale);
    for (const double depth : {0.13, 0.15}) {  // half of the points are below or not
      const Plane raised{Eigen::Vector3d::UnitZ(), -depth};
      EXPECT_EQ(frame_warnings(scaled.positions, field, testing::scaling_by(scale)(raised),
                               scale * tolerance),
                frame_warnings(vase.positions, testing::all_seen(vase), raised, tolerance))
          << "scale " << scale << ", depth " << depth;
    }
  }
}

TEST(OccupancyGrid, IsUnobservedUnlessAVoxelIsFreeOrOccupied) {
  OccupancyGrid grid;
  grid.states.assign(8, VoxelState::never_seen);
  EXPECT_TRUE(is_unobserved(grid));
  grid.states[5] = VoxelState::free;
  EXPECT_FALSE(is_unobserved(grid));
}

TEST(OutwardVote, GoesToTheSideWithFreeSpace) {
  const DistanceField field = half_space();
  const OutwardVote vote = outward_vote(field, flipped);
  EXPECT_GT(vote(Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ()), 0.0);
  EXPECT_LT(vote(Eigen::Vector3f::Zero(), -Eigen::Vector3f::UnitZ()), 0.0);
}

TEST(OutwardVote, GoesUpwardsWhereNoSpaceIsKnown) {
  const DistanceField field = testing::nothing_known(testing::vase());
  const Eigen::Vector3f above(0.0F, 0.0F, 0.1F), up(0.0F, 0.6F, 0.8F);
  EXPECT_GT(outward_vote(field, table)(above, up), 0.0);
  EXPECT_LT(outward_vote(field, flipped)(above, up), 0.0);
  EXPECT_GT(outward_vote(field, std::nullopt)(above, up), 0.0);
}

}  // namespace
}  // namespace symscene
