// Completed points and closed surfaces scale with the object, and completed points move with it.
#include <gtest/gtest.h>

#include "similarity.hpp"
#include "surfaces.hpp"
#include "symscene/completion/object_box.hpp"
#include "symscene/completion/object_surface.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene::testing {
namespace {

/// An object with its symmetries, and the table that it stands on.
struct SeenObject {
  PointCloud observed;
  std::vector<ObjectAxis> axes = {};
  std::vector<ObjectPlane> planes = {};
  std::optional<Plane> table = Plane{};

  SeenObject under(const Similarity& change) const {
    SeenObject changed{change(observed), change(axes), change(planes)};
    if (table) changed.table = change(*table);
    return changed;
  }
};

SeenObject seen_vase() { return {seen_from(vase(), {1.0F, 0.2F, 0.7F}), {{RotationAxis{}, 0.0}}}; }
SeenObject seen_box() {
  return {seen_from(box({0.1, 0.14, 0.08}), {1.0F, 0.8F, 1.0F}),
          {},
          {{{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}, 0.0},
           {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY()}, 0.01}}};
}

DistanceField field_around(const SeenObject& object, double scale = 1.0) {
  return unknown_distance_field(
      bounding_box(object.observed.positions).padded(static_cast<float>(0.2 * scale)),
      static_cast<float>(0.005 * scale), object.table,
      scaled_lengths(DistanceFieldOptions{}, scale));
}

PointCloud completed_points(const SeenObject& object, double scale = 1.0) {
  return complete_object(object.observed, object.axes, object.planes, field_around(object, scale),
                         scaled_lengths(CompletionOptions{}, scale));
}

ObjectSurface closed_surface(const SeenObject& object, double scale = 1.0) {
  return object_surface(
      {object.observed, completed_points(object, scale), object.axes, object.planes},
      {field_around(object, scale), object.table}, scaled_lengths(ObjectSurfaceOptions{}, scale),
      scaled_lengths(CompletionOptions{}, scale));
}

double greatest_difference(const Points& a, const Points& b) {
  return a.rows() == b.rows() ? static_cast<double>((a - b).cwiseAbs().maxCoeff()) : 1.0;
}

TEST(Completion, OfAScaledObjectIsScaled) {
  for (const SeenObject& object : {seen_vase(), seen_box()}) {
    const PointCloud here = completed_points(object);
    ASSERT_GT(here.size(), 100U);
    for (const double scale : scales) {
      const Similarity scaled_by = scaling_by(scale);
      const PointCloud there = completed_points(object.under(scaled_by), scale);
      EXPECT_LT(greatest_difference(there.positions, scaled_by(here.positions)), rounding * scale)
          << "scale " << scale;
    }
  }
}

/// The share of points that have none of the others within `distance`.
double share_without(const PointCloud& points, const PointCloud& others, float distance) {
  const CellList cells(others.positions, distance);
  double without = 0.0;
  for (Index i = 0; i < points.size(); ++i)
    without += cells.nearest(points.position(i), distance).first == CellList::none ? 1.0 : 0.0;
  return without / static_cast<double>(points.size());
}

TEST(Completion, OfAMovedObjectAddsPointsWhereItDidBefore) {
  // The points are thinned on a lattice that does not move: they shift by up to their spacing.
  constexpr float spacing = 0.005F;
  for (const SeenObject& object : {seen_vase(), seen_box()}) {
    const PointCloud here = completed_points(object);
    for (std::uint32_t seed = 41; seed < 44; ++seed) {
      const Similarity moved_by = motion_of(seed);
      const PointCloud there = completed_points(object.under(moved_by));
      EXPECT_LT(share_without(there, moved_by(here), spacing), 0.02) << "seed " << seed;
      EXPECT_LT(share_without(moved_by(here), there, spacing), 0.02) << "seed " << seed;
    }
  }
}

TEST(ObjectSurface, OfAScaledObjectIsScaled) {
  for (const SeenObject& object : {seen_vase(), seen_box()}) {
    const ObjectSurface here = closed_surface(object);
    ASSERT_GT(here.mesh.triangles.rows(), 100);
    for (const double scale : scales) {
      const Similarity scaled_by = scaling_by(scale);
      const ObjectSurface there = closed_surface(object.under(scaled_by), scale);
      EXPECT_LT(greatest_difference(there.mesh.vertices, scaled_by(here.mesh.vertices)),
                rounding * scale)
          << "scale " << scale;
      EXPECT_EQ(there.mesh.triangles, here.mesh.triangles) << "scale " << scale;
      EXPECT_EQ(there.observed, here.observed) << "scale " << scale;
    }
  }
}

TEST(ObjectSurface, OfAMovedObjectHasItsVolumeAndCentre) {
  for (const SeenObject& object : {seen_vase(), seen_box()}) {
    const SolidProperties here = solid_properties(closed_surface(object).mesh);
    for (std::uint32_t seed = 41; seed < 44; ++seed) {
      const Similarity moved_by = motion_of(seed);
      const SolidProperties there = solid_properties(closed_surface(object.under(moved_by)).mesh);
      // The cells of 3 mm are along the object; the space around it is on a lattice that is not.
      EXPECT_NEAR(there.volume / here.volume, 1.0, 0.02) << "seed " << seed;
      EXPECT_LT((there.centre_of_mass - moved_by.point(here.centre_of_mass)).norm(), 0.001)
          << "seed " << seed;
    }
  }
}

TEST(ObjectBox, OfAScaledObjectIsScaled) {
  const Points points = seen_box().observed.positions;
  const auto here = object_box(points, std::nullopt, Eigen::Vector3d::UnitZ());
  for (const double scale : scales) {
    const auto there =
        object_box(scaling_by(scale)(points), std::nullopt, Eigen::Vector3d::UnitZ());
    ASSERT_TRUE(here && there);
    EXPECT_LT((there->size - scale * here->size).norm(), rounding * scale);
    EXPECT_LT((there->T_world_box.position - scale * here->T_world_box.position).norm(),
              rounding * scale);
  }
}

}  // namespace
}  // namespace symscene::testing
