#include "symmetry/plane_features.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "surfaces.hpp"
#include "symmetry/object_symmetry.hpp"
#include "symmetry/symmetry_score.hpp"

namespace symscene {
namespace {

const ReflectionPlane upright{{0.0, 0.0, 0.1}, Eigen::Vector3d::UnitX()};
const Plane table{Eigen::Vector3d::UnitZ(), 0.0};

PlaneFeatures features_of(const PointCloud& cloud, const DistanceField& field,
                          const ReflectionPlane& plane, double object_score = 0.0) {
  const PlaneFeatureOptions options;
  const PlaneFeatureExtractor extractor(cloud, field, table, options);
  PlaneContext context;
  context.object_score = object_score;
  return extractor.features(extractor.match(plane), context);
}

TEST(PlaneFeatures, OfABoxAndItsMirror) {
  const PointCloud box = testing::box({0.1, 0.16, 0.2});
  const PlaneFeatures mirror = features_of(box, testing::all_seen(box), upright);
  EXPECT_GT(mirror.images.matched, 0.97);
  EXPECT_LT(mirror.images.contradicted(), 0.02);
  EXPECT_LT(mirror.images.plane_residual(), 0.02);
  EXPECT_GT(mirror.images.exact, 0.9);
  EXPECT_LT(mirror.images.residual, 0.0005);
  EXPECT_NEAR(mirror.extent, 0.1, 0.006);
  EXPECT_NEAR(mirror.length, 0.2, 0.006);
  EXPECT_NEAR(mirror.thickness, 0.1, 0.006);
  EXPECT_NEAR(mirror.balance, 0.5, 0.05);
  EXPECT_NEAR(mirror.upright, 0.0, 1e-6);
  // Two faces of 0.16 m by 0.2 m among 0.136 m² face along the normal; the others lie across it.
  EXPECT_NEAR(mirror.facing, 0.47, 0.05);
  EXPECT_NEAR(mirror.facing + mirror.across, 1.0, 0.03);
  EXPECT_LT(mirror.tilted, mirror.images.matched - 0.2);
}

TEST(PlaneFeatures, OfAPlaneThatIsNoMirror) {
  const PointCloud box = testing::box({0.1, 0.16, 0.2});
  const DistanceField seen = testing::all_seen(box);
  const ReflectionPlane oblique{{0.0, 0.0, 0.1}, Eigen::Vector3d(1.0, 1.0, 0.0).normalized()};
  const PlaneFeatures diagonal = features_of(box, seen, oblique);
  EXPECT_GT(diagonal.images.plane_residual(), 0.4);
  EXPECT_GT(diagonal.images.empty, 0.1);
  EXPECT_GT(diagonal.images.buried, 0.1);
  const PlaneFeatures shifted =
      features_of(box, seen, {{0.02, 0.0, 0.1}, Eigen::Vector3d::UnitX()});
  EXPECT_LT(shifted.images.steep_matched, 0.1);  // its faces miss each other
  EXPECT_GT(shifted.images.matched, 0.2);        // what lies across the normal slides along itself
}

TEST(PlaneFeatures, OfABallAreRound) {
  const std::array parts{Ellipsoid{{0.0, 0.0, 0.1}, {0.05, 0.05, 0.05}}};
  const PointCloud ball = testing::as_cloud(make_mirrored_body(parts, 0.001, 0.005));
  EXPECT_LT(features_of(ball, testing::nothing_known(ball), upright).roundness, 0.01);
  const PointCloud box = testing::box({0.1, 0.16, 0.2});
  EXPECT_GT(features_of(box, testing::nothing_known(box), upright).roundness, 0.05);
}

TEST(PlaneFeatures, UnobservedImagesDoNotContradict) {
  const PointCloud box = testing::box({0.1, 0.16, 0.2});
  const PointCloud half = testing::seen_from(box, {5.0F, 1.0F, 5.0F});
  const PlaneFeatures features = features_of(half, testing::nothing_known(box), upright);
  EXPECT_LT(features.images.contradicted(), 0.05);
  EXPECT_LT(features.images.matched, 0.8);
}

TEST(PlaneScore, IsAProbabilityForAnyFeatures) {
  for (const double value : {-1e300, 0.0, 0.5, 1e300, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    PlaneFeatures features;
    PlaneFeatures::visit_fields(features, [&](const char*, double& field) { field = value; });
    EXPECT_GT(plane_probability(features), 0.0);
    EXPECT_LT(plane_probability(features), 1.0);
  }
}

TEST(PlaneScore, IsHighForTheMirrorPlanesOfABoxAndLowForItsDiagonals) {
  const PointCloud box = testing::box({0.06, 0.08, 0.1});
  const DistanceField field = testing::all_seen(box);
  const PointCloud seen = testing::seen_from(box, {1.0F, 0.3F, 0.8F});
  SearchedObject object;
  object.points = testing::all_of(seen);
  object.score = 0.9;
  const std::optional<Plane> below = table;
  const SymmetryCandidates found = symmetry_candidates({seen, field, below}, object, {});
  int mirrors = 0, diagonals = 0;
  for (const PlaneCandidate& plane : found.planes) {
    const bool is_mirror = plane.plane.normal.cwiseAbs().maxCoeff() > 0.99;
    ++(is_mirror ? mirrors : diagonals);
    if (is_mirror) {
      EXPECT_GT(plane.probability, 0.8);
    } else {  // one is that of a base of 6 by 8 cm
      EXPECT_LT(plane.probability, ObjectSymmetryOptions().min_plane_probability);
    }
  }
  EXPECT_EQ(mirrors, 3);
  EXPECT_GE(diagonals, 1);
}

}  // namespace
}  // namespace symscene
