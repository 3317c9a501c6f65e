// Detected symmetries move and scale with what they are detected on.
#include <gtest/gtest.h>

#include "scaled_models.hpp"
#include "similarity.hpp"

#include "surfaces.hpp"
#include "symmetry/group_orders.hpp"
#include "symmetry/object_symmetry.hpp"
#include "symmetry/sphere_fit.hpp"
#include "symscene/symmetry/reflectional_detection.hpp"
#include "symscene/symmetry/rotational_detection.hpp"
#include "symscene/symmetry/single_object.hpp"
#include "symscene/symmetry/symmetry_group.hpp"

namespace symscene::testing {
namespace {

constexpr std::uint32_t motion_seeds[] = {11, 12, 13};

/// What one camera sees of a vase, and a whole carton.
PointCloud half_vase() { return seen_from(vase(), {1.0F, 1.0F, 1.0F}); }
PointCloud whole_carton() { return box({0.1, 0.16, 0.22}); }

std::vector<RotationAxis> detected_axes(const PointCloud& cloud, const DistanceField& field,
                                        double scale = 1.0) {
  return axes_of(detect_rotational(cloud, {all_of(cloud)}, field, std::nullopt,
                                   scaled_lengths(RotationalDetectionOptions{}, scale))
                     .candidates);
}

std::vector<ReflectionPlane> detected_planes(const PointCloud& cloud, const DistanceField& field,
                                             double scale = 1.0) {
  return planes_of(detect_reflectional(cloud, {all_of(cloud)}, field, std::nullopt,
                                       scaled_lengths(ReflectionalDetectionOptions{}, scale))
                       .candidates);
}

/// Positions 2 m from the origin are rounded to 0.1 µm, and a fit ends within its tolerance.
constexpr double axis_angle = 1e-3;     // [rad]
constexpr double axis_distance = 1e-4;  // [m]

TEST(RotationalDetection, OfAMovedSurfaceIsTheMovedAxis) {
  const PointCloud cloud = half_vase();
  const std::vector<RotationAxis> axes = detected_axes(cloud, nothing_known(cloud));
  ASSERT_EQ(axes.size(), 1U);
  for (const std::uint32_t seed : motion_seeds) {
    const Similarity moved_by = motion_of(seed);
    const PointCloud moved = moved_by(cloud);
    EXPECT_TRUE(are_the_same(detected_axes(moved, nothing_known(moved)), moved_by(axes),
                             centroid(moved.positions), axis_angle, axis_distance))
        << "seed " << seed;
  }
}

TEST(RotationalDetection, OfAScaledSurfaceIsTheScaledAxis) {
  const PointCloud cloud = half_vase();
  const std::vector<RotationAxis> axes = detected_axes(cloud, nothing_known(cloud));
  ASSERT_EQ(axes.size(), 1U);
  for (const double scale : scales) {
    const PointCloud scaled = scaling_by(scale)(cloud);
    EXPECT_TRUE(are_the_same(detected_axes(scaled, nothing_known(scaled, scale), scale),
                             scaling_by(scale)(axes), centroid(scaled.positions), rounding,
                             rounding * scale))
        << "scale " << scale;
  }
}

TEST(RotationalDetection, QualityInFreeSpaceIsThatOfTheScaledSurface) {
  const PointCloud cloud = half_vase();
  RotationalDetectionOptions options;
  options.max_occlusion_residual = 1.0;
  const auto detected = [&](const PointCloud& points, double scale) {
    return detect_rotational(points, {all_of(points)}, all_seen(points, scale), std::nullopt,
                             scaled_lengths(options, scale))
        .candidates;
  };
  const auto here = detected(cloud, 1.0);
  ASSERT_EQ(here.size(), 1U);
  EXPECT_GT(here[0].quality.occlusion_residual, 0.0);
  for (const double scale : scales) {
    const auto there = detected(scaling_by(scale)(cloud), scale);
    ASSERT_EQ(there.size(), 1U) << "scale " << scale;
    EXPECT_NEAR(there[0].quality.occlusion_residual, here[0].quality.occlusion_residual, rounding);
    EXPECT_NEAR(there[0].quality.symmetry_residual, here[0].quality.symmetry_residual, rounding);
    EXPECT_NEAR(there[0].quality.coverage, here[0].quality.coverage, rounding);
  }
}

/// Fits of planes end when a step is below 0.2° and 0.3 mm, and are tried in an order that depends
/// on the signs of the principal axes.
const double plane_angle = radians(0.5);
constexpr double plane_distance = 1e-3;  // [m]

TEST(ReflectionalDetection, OfAMovedSurfaceAreTheMovedPlanes) {
  const PointCloud cloud = whole_carton();
  const std::vector<ReflectionPlane> planes = detected_planes(cloud, nothing_known(cloud));
  ASSERT_GE(planes.size(), 3U);
  for (const std::uint32_t seed : motion_seeds) {
    const Similarity moved_by = motion_of(seed);
    const PointCloud moved = moved_by(cloud);
    EXPECT_TRUE(are_the_same(detected_planes(moved, nothing_known(moved)), moved_by(planes),
                             centroid(moved.positions), plane_angle, plane_distance))
        << "seed " << seed;
  }
}

TEST(ReflectionalDetection, OfAScaledSurfaceAreTheScaledPlanes) {
  const PointCloud seen = seen_from(whole_carton(), {1.0F, 0.8F, 1.0F});
  for (const PointCloud& cloud : {whole_carton(), seen}) {
    for (const bool in_free_space : {false, true}) {
      const auto field = [&](const PointCloud& points, double scale) {
        return in_free_space ? all_seen(points, scale) : nothing_known(points, scale);
      };
      const std::vector<ReflectionPlane> planes = detected_planes(cloud, field(cloud, 1.0));
      for (const double scale : scales) {
        const PointCloud scaled = scaling_by(scale)(cloud);
        EXPECT_TRUE(are_the_same(detected_planes(scaled, field(scaled, scale), scale),
                                 scaling_by(scale)(planes), centroid(scaled.positions), rounding,
                                 rounding * scale))
            << "scale " << scale << ", " << cloud.size() << " points, free space " << in_free_space;
      }
    }
  }
}

/// The candidates of an object that is all of its scene and stands on a table.
SymmetryCandidates candidates_of(const PointCloud& cloud, const std::optional<Plane>& table,
                                 double scale = 1.0) {
  SymmetrySearchOptions options = scaled_lengths(SymmetrySearchOptions{}, scale);
  options.axis_model = scaled_axis_model(scale);
  options.plane_model = scaled_plane_model(scale);
  const DistanceField field = nothing_known(cloud, scale);
  return symmetry_candidates({cloud, field, table}, {all_of(cloud), 0.9}, options);
}

const std::optional<Plane> level_table = Plane{Eigen::Vector3d::UnitZ(), 0.0};

TEST(SymmetryCandidates, OfAMovedObjectAreTheMovedOnes) {
  for (const PointCloud& cloud : {half_vase(), whole_carton()}) {
    const ListedSymmetries here = list_symmetries(candidates_of(cloud, level_table), {});
    ASSERT_GE(here.rotational.size() + here.reflectional.size(), 1U);
    for (const std::uint32_t seed : motion_seeds) {
      const Similarity moved_by = motion_of(seed);
      const PointCloud moved = moved_by(cloud);
      const ListedSymmetries there =
          list_symmetries(candidates_of(moved, moved_by(*level_table)), {});
      const Eigen::Vector3d center = centroid(moved.positions);
      EXPECT_TRUE(are_the_same(axes_of(there.rotational), moved_by(axes_of(here.rotational)),
                               center, axis_angle, axis_distance))
          << "seed " << seed;
      EXPECT_TRUE(are_the_same(planes_of(there.reflectional),
                               moved_by(planes_of(here.reflectional)), center, plane_angle,
                               plane_distance))
          << "seed " << seed;
    }
  }
}

TEST(SymmetryCandidates, OfAScaledObjectAreTheScaledOnesWithTheSameProbabilities) {
  for (const PointCloud& cloud : {half_vase(), whole_carton()}) {
    const SymmetryCandidates here = candidates_of(cloud, level_table);
    for (const double scale : scales) {
      const PointCloud scaled = scaling_by(scale)(cloud);
      const SymmetryCandidates there = candidates_of(scaled, level_table, scale);
      ASSERT_EQ(there.axis.has_value(), here.axis.has_value()) << "scale " << scale;
      if (here.axis) {
        EXPECT_NEAR(there.axis->probability, here.axis->probability, rounding);
        EXPECT_NEAR(there.axis->features.radius, scale * here.axis->features.radius,
                    rounding * scale);
      }
      ASSERT_EQ(there.planes.size(), here.planes.size()) << "scale " << scale;
      for (std::size_t k = 0; k < here.planes.size(); ++k)
        EXPECT_NEAR(there.planes[k].probability, here.planes[k].probability, rounding);
      EXPECT_TRUE(are_the_same(planes_of(there.planes), scaling_by(scale)(planes_of(here.planes)),
                               centroid(scaled.positions), rounding, rounding * scale));
    }
  }
}

/// The object is sampled on a lattice that does not move with it.
const double single_object_angle = radians(1.0);
constexpr double single_object_distance = 2e-3;  // [m]

TEST(SingleObject, OfAMovedObjectHasTheMovedSymmetries) {
  for (const PointCloud& cloud : {vase(), whole_carton()}) {
    const ObjectSymmetries here = detect_object_symmetries(cloud);
    ASSERT_GE(here.rotational.size() + here.reflectional.size(), 1U);
    for (const std::uint32_t seed : motion_seeds) {
      const Similarity moved_by = motion_of(seed);
      const ObjectSymmetries there = detect_object_symmetries(moved_by(cloud));
      EXPECT_TRUE(are_the_same(axes_of(there.rotational), moved_by(axes_of(here.rotational)),
                               there.centroid, single_object_angle, single_object_distance))
          << "seed " << seed;
      EXPECT_TRUE(are_the_same(planes_of(there.reflectional),
                               moved_by(planes_of(here.reflectional)), there.centroid,
                               single_object_angle, single_object_distance))
          << "seed " << seed;
    }
  }
}

TEST(SingleObject, OfAScaledObjectHasTheScaledSymmetriesWithTheSameOptions) {
  for (const PointCloud& cloud : {vase(), whole_carton()}) {
    const ObjectSymmetries here = detect_object_symmetries(cloud);
    for (const double scale : scales) {
      const Similarity scaled_by = scaling_by(scale);
      const ObjectSymmetries there = detect_object_symmetries(scaled_by(cloud));
      EXPECT_EQ(there.points, here.points);
      EXPECT_TRUE(are_the_same(axes_of(there.rotational), scaled_by(axes_of(here.rotational)),
                               there.centroid, rounding, rounding * scale));
      EXPECT_TRUE(are_the_same(planes_of(there.reflectional),
                               scaled_by(planes_of(here.reflectional)), there.centroid, rounding,
                               rounding * scale));
    }
  }
}

/// The upper part of a ball with a radius of 5 cm, and a flat disc.
PointCloud ball_cap() {
  const std::vector<Ellipsoid> ball{{{0.0, 0.0, 0.1}, {0.05, 0.05, 0.05}}};
  return seen_from(as_cloud(make_mirrored_body(ball, 0.001, 0.005)), {0.0F, 0.0F, 0.2F});
}
PointCloud flat_face() { return seen_from(whole_carton(), {0.0F, 0.0F, 0.221F}); }

TEST(SphereFit, MovesAndScalesWithTheSurface) {
  const PointCloud cloud = ball_cap();
  const auto here = sphere_center(cloud, {});
  ASSERT_TRUE(here);
  for (const std::uint32_t seed : motion_seeds) {
    for (const double scale : {0.5, 1.0, 2.0}) {
      const Similarity changed_by{motion_of(seed).motion, scale};
      const auto there = sphere_center(changed_by(cloud), {});
      ASSERT_TRUE(there) << "seed " << seed;
      EXPECT_LT((*there - changed_by.point(*here)).norm(), 1e-5 * scale) << "seed " << seed;
      EXPECT_NEAR(distance_off_sphere(changed_by(cloud).positions),
                  distance_off_sphere(cloud.positions), 1e-5);
    }
  }
}

TEST(SphereFit, OfAFlatFaceIsNoneHoweverFarFromTheOrigin) {
  const PointCloud face = flat_face();
  ASSERT_GT(face.size(), 100U);
  for (const double distance : {0.0, 1.0, 100.0}) {
    const Similarity away{Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, -distance)), 1.0};
    EXPECT_FALSE(sphere_center(away(face), {})) << "at " << distance << " m";
  }
}

SymmetryGroupOptions few_directions() {
  SymmetryGroupOptions options;
  options.directions = 600;
  options.coarse_points = 100;
  options.fit_points = 200;
  options.residual_points = 400;
  return options;
}

/// A box, a bar with a six-fold axis, and a cone, whose axis is continuous.
std::vector<PointCloud> whole_surfaces() {
  const std::vector<ProfilePoint> bar{{0.0, 0.0}, {0.06, 0.0}, {0.06, 0.16}, {0.0, 0.16}};
  const std::vector<ProfilePoint> cone{{0.0, 0.0}, {0.05, 0.0}, {0.0, 0.12}};
  return {sample_surface(make_box({0.1, 0.16, 0.23}, 0.023), 6000),
          sample_surface(make_revolution(bar, 6, 0.2), 6000),
          sample_surface(make_revolution(cone, 64, 0.01), 6000)};
}

/// Whether a group has the rotations of another one that is moved and scaled.
bool has_rotations(const SymmetryGroup& group, const SymmetryGroup& expected, const Similarity& by,
                   double angle) {
  const Eigen::Matrix3d turn = by.motion.linear();
  return group.rotations.size() == expected.rotations.size() &&
         std::all_of(expected.rotations.begin(), expected.rotations.end(), [&](const auto& e) {
           const Eigen::Matrix3d there = turn * e.linear() * turn.transpose();
           return std::any_of(group.rotations.begin(), group.rotations.end(), [&](const auto& g) {
             return Eigen::AngleAxisd(g.linear() * there.transpose()).angle() < angle;
           });
         });
}

TEST(SymmetryGroup, OfAMovedSurfaceIsTheMovedGroup) {
  // Directions are tried on a lattice that does not move, and fits end within 0.2 % of the
  // diagonal.
  const double angle = radians(0.5);
  constexpr double distance = 6e-4;  // [m]
  for (const PointCloud& surface : whole_surfaces()) {
    const SymmetryGroup here = find_symmetry_group(surface, few_directions());
    ASSERT_FALSE(here.axes.empty());
    for (const std::uint32_t seed : motion_seeds) {
      const Similarity moved_by = motion_of(seed);
      const SymmetryGroup there = find_symmetry_group(moved_by(surface), few_directions());
      EXPECT_EQ(orders_of(there), orders_of(here)) << "seed " << seed;
      EXPECT_TRUE(are_the_same(axes_of(there.axes), moved_by(axes_of(here.axes)), there.center,
                               angle, distance))
          << "seed " << seed;
      EXPECT_TRUE(are_the_same(planes_of(there.planes), moved_by(planes_of(here.planes)),
                               there.center, angle, distance))
          << "seed " << seed;
      EXPECT_TRUE(has_rotations(there, here, moved_by, 2.0 * angle)) << "seed " << seed;
      EXPECT_LT((there.center - moved_by.point(here.center)).norm(), distance) << "seed " << seed;
      EXPECT_NEAR(there.diameter, here.diameter, 1e-6) << "seed " << seed;
    }
  }
}

TEST(SymmetryGroup, OfAScaledSurfaceIsTheScaledGroupWithTheSameOptions) {
  for (const PointCloud& surface : whole_surfaces()) {
    const SymmetryGroup here = find_symmetry_group(surface, few_directions());
    for (const double scale : scales) {
      const Similarity scaled_by = scaling_by(scale);
      const SymmetryGroup there = find_symmetry_group(scaled_by(surface), few_directions());
      ASSERT_EQ(orders_of(there), orders_of(here)) << "scale " << scale;
      ASSERT_EQ(there.planes.size(), here.planes.size()) << "scale " << scale;
      EXPECT_TRUE(are_the_same(axes_of(there.axes), scaled_by(axes_of(here.axes)), there.center,
                               rounding, rounding * scale));
      EXPECT_TRUE(are_the_same(planes_of(there.planes), scaled_by(planes_of(here.planes)),
                               there.center, rounding, rounding * scale));
      EXPECT_TRUE(has_rotations(there, here, scaled_by, rounding));
      for (std::size_t k = 0; k < here.axes.size(); ++k)
        EXPECT_NEAR(there.axes[k].residual, scale * here.axes[k].residual, rounding * scale);
      for (std::size_t k = 0; k < here.planes.size(); ++k)
        EXPECT_NEAR(there.planes[k].residual, scale * here.planes[k].residual, rounding * scale);
    }
  }
}

TEST(SymmetryGroup, OfABallMovesAndScales) {
  const std::vector<Ellipsoid> ball{{{0.0, 0.0, 0.1}, {0.05, 0.05, 0.05}}};
  const PointCloud surface = sample_surface(make_mirrored_body(ball, 0.001, 0.005), 6000);
  const SymmetryGroup here = find_symmetry_group(surface, few_directions());
  ASSERT_TRUE(here.sphere);
  for (const std::uint32_t seed : motion_seeds) {
    for (const double scale : {0.5, 1.0, 2.0}) {
      const Similarity changed_by{motion_of(seed).motion, scale};
      const SymmetryGroup there = find_symmetry_group(changed_by(surface), few_directions());
      EXPECT_TRUE(there.sphere) << "seed " << seed;
      EXPECT_LT((there.center - changed_by.point(here.center)).norm(), 1e-5 * scale);
      EXPECT_NEAR(there.sphere_residual, scale * here.sphere_residual, 1e-6 * scale);
    }
  }
}

}  // namespace
}  // namespace symscene::testing
