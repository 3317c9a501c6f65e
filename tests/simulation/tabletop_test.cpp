#include "symscene/simulation/tabletop.hpp"

#include <gtest/gtest.h>

#include "simulation/footprint.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

TabletopOptions options_for(std::uint64_t seed, int objects) {
  TabletopOptions options;
  options.seed = seed;
  options.objects = objects;
  return options;
}

double height(const ObjectModel& model) { return model.mesh.vertices.col(2).maxCoeff(); }

/// Where another object stands: a hollow's floor, or the top.
double standing_height(const ObjectModel& model) {
  if (model.name != "bowl" && model.name != "cup") return height(model);
  const auto& at = model.mesh.vertices;
  double floor = 0.0;
  for (Eigen::Index i = 0; i < at.rows(); ++i) {
    if (at.row(i).head<2>().norm() < 1e-6F) floor = std::max<double>(floor, at(i, 2));
  }
  return floor;
}

TEST(Footprint, SeparationOfSquaresIsTheGapBetweenThem) {
  const Footprint square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_NEAR(separation(square, moved(square, 0, {1.5, 0.3})), 0.5, 1e-12);
  EXPECT_NEAR(separation(square, moved(square, 0, {0.75, 0})), -0.25, 1e-12);
}

TEST(Footprint, OutlineOfABoxIsItsRectangle) {
  const Footprint outline = convex_outline(make_box({0.2, 0.1, 0.3}, 0.02).vertices);
  EXPECT_EQ(outline.size(), 4U);
}

TEST(Tabletop, HasTheNumberOfObjectsInTheOptions) {
  for (const int count : {1, 5, 15}) {
    EXPECT_EQ(arrange_tabletop(options_for(4, count)).objects.size(),
              static_cast<std::size_t>(count));
  }
}

TEST(Tabletop, ObjectsDoNotIntersect) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Tabletop tabletop = arrange_tabletop(options_for(seed, 8));
    for (const PlacedObject& a : tabletop.objects) {
      for (const PlacedObject& b : tabletop.objects) {
        if (&a == &b) continue;
        const Eigen::Isometry3d T_b_a = b.T_world_object.inverse() * a.T_world_object;
        // Corners, rims and every 53rd vertex of a against the solid of b, but for what rests on
        // it.
        for (Eigen::Index i = 0; i < a.object.mesh.vertices.rows(); i += 53) {
          const Eigen::Vector3d p =
              T_b_a * a.object.mesh.vertices.row(i).transpose().cast<double>();
          if (p.z() > height(b.object) - 1e-4 || p.z() < 1e-4) continue;
          const bool rests_in = p.z() < standing_height(b.object) + 1e-4;
          ASSERT_FALSE(!rests_in && is_inside(b.object.mesh, p))
              << "seed " << seed << ": " << a.object.name << " in " << b.object.name;
        }
      }
    }
  }
}

TEST(Tabletop, ObjectsRestOnTheTableOrOnTheirSupporter) {
  int stacked = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Tabletop tabletop = arrange_tabletop(options_for(seed, 10));
    for (const PlacedObject& placed : tabletop.objects) {
      const double base =
          (tabletop.T_world_table.inverse() * placed.T_world_object).translation().z();
      if (placed.supporter == PlacedObject::on_table) {
        EXPECT_NEAR(base, 0.0, 1e-12);
        continue;
      }
      ++stacked;
      const PlacedObject& below = tabletop.objects[placed.supporter];
      EXPECT_NEAR(base, below.T_world_object.translation().z() + standing_height(below.object),
                  1e-7);
    }
  }
  EXPECT_GT(stacked, 5);
}

TEST(Tabletop, RandomFrameMovesTheWorldButNotTheArrangement) {
  TabletopOptions options = options_for(9, 5);
  const Tabletop upright = arrange_tabletop(options);
  options.random_frame = true;
  const Tabletop turned = arrange_tabletop(options);
  EXPECT_GT(angle_between(turned.plane().normal, Eigen::Vector3d::UnitZ()), 0.05);
  for (std::size_t i = 0; i < upright.objects.size(); ++i) {
    const Eigen::Isometry3d back =
        turned.T_world_table.inverse() * turned.objects[i].T_world_object;
    EXPECT_TRUE(back.isApprox(upright.objects[i].T_world_object, 1e-12));
    EXPECT_GT(turned.plane().signed_distance(turned.objects[i].T_world_object *
                                             Eigen::Vector3d(0, 0, 0.05)),
              0.0);
  }
}

TEST(Tabletop, RefusesMoreObjectsThanFit) {
  EXPECT_THROW(arrange_tabletop(options_for(1, 21)), InputError);
  EXPECT_THROW(arrange_tabletop(options_for(1, 0)), InputError);
}

}  // namespace
}  // namespace symscene
