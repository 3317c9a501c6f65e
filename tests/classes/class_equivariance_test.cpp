// The class of an object moves and scales with its points.
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "core/random.hpp"
#include "similarity.hpp"
#include "surfaces.hpp"
#include "symscene/classes/classification.hpp"

namespace symscene::testing {
namespace {

/// A surface of revolution with a base of `sides` corners, 5 mm from point to point, with errors of
/// 0.5 mm along its normals.
PointCloud scanned_solid(std::span<const ProfilePoint> profile, int sides) {
  PointCloud cloud = as_cloud(make_revolution(profile, sides, sides < 10 ? 0.5 : 0.005));
  Random random(3);
  for (Index i = 0; i < cloud.size(); ++i)
    cloud.positions.row(i) += static_cast<float>(0.0005 * random.normal()) * cloud.normals.row(i);
  return cloud;
}

PointCloud scanned_prism(int sides, double radius) {
  const std::array<ProfilePoint, 4> profile = {
      {{0.0, 0.0}, {radius, 0.0}, {radius, 0.12}, {0.0, 0.12}}};
  return scanned_solid(profile, sides);
}

PointCloud scanned_ball() {
  std::vector<ProfilePoint> profile;
  for (int k = 0; k <= 48; ++k) {
    const double angle = std::numbers::pi * k / 48;
    profile.push_back({k % 48 == 0 ? 0.0 : 0.04 * std::sin(angle), 0.04 * (1.0 - std::cos(angle))});
  }
  return scanned_solid(profile, 96);
}

struct ScannedSolid {
  SymmetryClass kind;
  PointCloud cloud;
  std::size_t fixed_axes;  ///< columns of ObjectClass::axes, from the last, that the class fixes
};

const std::vector<ScannedSolid>& scanned_solids() {
  static const std::vector<ScannedSolid> all = {
      {SymmetryClass::box, box({0.16, 0.06, 0.22}), 3},
      {SymmetryClass::n_fold, scanned_prism(6, 0.046), 1},
      {SymmetryClass::cylinder, scanned_prism(96, 0.035), 1},
      {SymmetryClass::sphere, scanned_ball(), 0}};
  return all;
}

ObjectClass class_at(const PointCloud& cloud, double scale = 1.0) {
  const std::vector<ObjectAxis> no_axis;
  const std::vector<ObjectPlane> no_plane;
  const std::optional<Plane> unknown_table;
  const DistanceField field = nothing_known(cloud, scale);
  return classify({cloud, 0.005 * scale, no_axis, no_plane, field, unknown_table});
}

/// Whether a class is that of a moved or scaled object, up to a share of its lengths.
void expect_moved_class(const ObjectClass& found, const ObjectClass& before,
                        const Similarity& moved_by, const ScannedSolid& solid, double share) {
  constexpr double size = 0.1;  // [m]
  const double length = share * size * moved_by.scale;
  ASSERT_EQ(found.kind, before.kind);
  EXPECT_EQ(found.order, before.order);
  EXPECT_LT((found.center - moved_by.point(before.center)).norm(), length);
  for (std::size_t k = 3 - solid.fixed_axes; k < 3; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    EXPECT_LT(line_angle(found.axes.col(column), moved_by.direction(before.axes.col(column))),
              share);
  }
  EXPECT_NEAR(found.residual, moved_by.scale * before.residual, length);
  ASSERT_EQ(found.dimensions.size(), before.dimensions.size());
  for (std::size_t k = 0; k < before.dimensions.size(); ++k) {
    const Dimension &a = found.dimensions[k], &b = before.dimensions[k];
    EXPECT_EQ(a.name, b.name);
    EXPECT_NEAR(a.value, moved_by.scale * b.value, length) << a.name;
    ASSERT_EQ(a.sigma.has_value(), b.sigma.has_value()) << a.name;
    EXPECT_NEAR(a.sigma.value_or(0.0), moved_by.scale * b.sigma.value_or(0.0), length) << a.name;
  }
}

TEST(Classification, OfEveryKindMovesWithThePoints) {
  for (const ScannedSolid& solid : scanned_solids()) {
    const ObjectClass before = class_at(solid.cloud);
    ASSERT_EQ(before.kind, solid.kind);
    for (std::uint32_t seed = 31; seed < 34; ++seed) {
      SCOPED_TRACE(std::string(to_string(solid.kind)) + ", seed " + std::to_string(seed));
      const Similarity moved_by = motion_of(seed);
      // Fits end when the loss falls by less than a millionth.
      expect_moved_class(class_at(moved_by(solid.cloud)), before, moved_by, solid, 1e-3);
    }
  }
}

TEST(Classification, OfEveryKindScalesWithThePointsAndTheirSpacing) {
  for (const ScannedSolid& solid : scanned_solids()) {
    const ObjectClass before = class_at(solid.cloud);
    for (const double scale : scales) {
      SCOPED_TRACE(std::string(to_string(solid.kind)) + ", scale " + std::to_string(scale));
      expect_moved_class(class_at(scaling_by(scale)(solid.cloud), scale), before, scaling_by(scale),
                         solid, rounding);
    }
  }
}

}  // namespace
}  // namespace symscene::testing
