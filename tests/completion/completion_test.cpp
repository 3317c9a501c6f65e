#include "symscene/completion/completion.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

DistanceField nothing_known() {
  return unknown_distance_field({Eigen::Vector3f::Constant(-0.3F), Eigen::Vector3f::Constant(0.3F)},
                                0.005F, std::nullopt);
}

/// The share of `whole` that has a point of either part within 7 mm.
double share_covered(const PointCloud& whole, const PointCloud& observed, const PointCloud& added) {
  const CellList observed_cells(observed.positions, 0.01F);
  const CellList added_cells(added.positions, 0.01F);
  std::size_t covered = 0;
  for (Index i = 0; i < whole.size(); ++i) {
    const Eigen::Vector3f p = whole.position(i);
    covered += observed_cells.nearest(p, 0.007F).first != CellList::none ||
                       added_cells.nearest(p, 0.007F).first != CellList::none
                   ? 1
                   : 0;
  }
  return static_cast<double>(covered) / whole.size();
}

/// The farthest that an added point lies from the whole.
double worst_distance(const PointCloud& added, const PointCloud& whole) {
  const CellList cells(whole.positions, 0.05F);
  double worst = 0.0;
  for (Index i = 0; i < added.size(); ++i) {
    const auto [j, squared] = cells.nearest(added.position(i), 0.05F);
    worst = std::max(worst, j == CellList::none ? 1.0 : std::sqrt(double{squared}));
  }
  return worst;
}

TEST(Completion, RotatesTheObservedSideOfAVaseIntoTheWhole) {
  const PointCloud whole = testing::vase();
  const PointCloud seen = testing::seen_from(whole, {1.0F, 0.2F, 0.7F});
  const PointCloud added = complete_object(seen, {{RotationAxis{}, 0.0}}, {}, nothing_known());
  EXPECT_LT(worst_distance(added, whole), 0.006);
  PointIndices sides;  // the foot was not observed and no rotation adds it
  for (Index i = 0; i < whole.size(); ++i) {
    if (whole.normals(i, 2) > -0.5F) sides.push_back(i);
  }
  EXPECT_GT(share_covered(select(whole, sides), seen, added), 0.98);
}

TEST(Completion, ReflectsByThePlanesAndTheirProducts) {
  const PointCloud whole = testing::box({0.1, 0.14, 0.08});
  PointIndices quarter;
  for (Index i = 0; i < whole.size(); ++i) {
    if (whole.positions(i, 0) > -0.003F && whole.positions(i, 1) > -0.003F) quarter.push_back(i);
  }
  const PointCloud seen = select(whole, quarter);
  const std::vector<ObjectPlane> planes{{{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}, 0.0},
                                        {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY()}, 0.0}};
  const PointCloud added = complete_object(seen, {}, planes, nothing_known());
  EXPECT_GT(share_covered(whole, seen, added), 0.99);
  EXPECT_LT(worst_distance(added, whole), 0.006);
  for (Index i = 0; i < added.size(); ++i) EXPECT_NEAR(added.normal(i).norm(), 1.0F, 1e-4F);
}

TEST(Completion, AddsNothingWhereTheObjectWasObserved) {
  const PointCloud whole = testing::vase();
  const PointCloud added = complete_object(whole, {{RotationAxis{}, 0.0}}, {}, nothing_known());
  EXPECT_LT(added.size(), whole.size() / 100);
}

TEST(Completion, AddsNothingInFreeSpace) {
  OccupancyGrid grid = rasterize(
      OccupancyMap{}, {Eigen::Vector3f::Constant(-0.3F), Eigen::Vector3f::Constant(0.3F)});
  std::fill(grid.states.begin(), grid.states.end(), VoxelState::free);
  const PointCloud seen = testing::seen_from(testing::vase(), {1.0F, 0.0F, 0.7F});
  EXPECT_EQ(
      complete_object(seen, {{RotationAxis{}, 0.0}}, {}, distance_field(grid, std::nullopt)).size(),
      0U);
}

TEST(CentreOfMass, LiesOnEverySymmetry) {
  const PointCloud seen = testing::seen_from(testing::vase(), {1.0F, 0.3F, 0.5F});
  const RotationAxis axis;
  EXPECT_LT(axis.distance(centre_of_mass({seen, PointCloud{}, {{axis, 0.0}}, {}})), 1e-9);
  const ReflectionPlane a{{0.01, 0.0, 0.0}, Eigen::Vector3d(1.0, 0.2, 0.0).normalized()};
  const ReflectionPlane b{{0.0, 0.02, 0.0}, Eigen::Vector3d(0.1, 1.0, 0.3).normalized()};
  const Eigen::Vector3d centre = centre_of_mass({seen, PointCloud{}, {}, {{a, 0.0}, {b, 0.0}}});
  EXPECT_NEAR(a.signed_distance(centre), 0.0, 1e-9);
  EXPECT_NEAR(b.signed_distance(centre), 0.0, 1e-9);
}

TEST(CentreOfMass, IsNotMovedByPlanesThatBarelyDifferAlongTheirBisector) {
  const PointCloud seen = testing::seen_from(testing::vase(), {1.0F, 0.3F, 0.5F});
  const ReflectionPlane a{{0.0, 0.0, 0.0}, Eigen::Vector3d(1.0, 0.04, 0.0).normalized()};
  const ReflectionPlane b{{0.004, 0.0, 0.0}, Eigen::Vector3d(1.0, -0.04, 0.0).normalized()};
  const Eigen::Vector3d mean = centroid(seen.positions);
  const Eigen::Vector3d centre = centre_of_mass({seen, PointCloud{}, {}, {{a, 0.0}, {b, 0.0}}});
  EXPECT_NEAR(centre.y(), mean.y(), 0.005);
  EXPECT_NEAR(centre.x(), 0.002, 0.005);
}

TEST(Completion, RefusesASpacingOfZero) {
  CompletionOptions options;
  options.spacing = 0.0;
  EXPECT_THROW(complete_object(testing::vase(), {}, {}, nothing_known(), options), InputError);
}

}  // namespace
}  // namespace symscene
