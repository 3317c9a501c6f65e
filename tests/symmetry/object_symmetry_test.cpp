#include "symmetry/object_symmetry.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

SymmetryCandidates likely_and_unlikely() {
  SymmetryCandidates candidates;
  candidates.axis = AxisCandidate{{}, {}, 0.3};
  const Eigen::Vector3d here = Eigen::Vector3d::Zero();
  candidates.planes.push_back({{here, Eigen::Vector3d::UnitX()}, {}, 0.9});
  candidates.planes.push_back({{here, Eigen::Vector3d::UnitY()}, {}, 0.4});
  return candidates;
}

TEST(ListSymmetries, ThatAreProbableEnough) {
  ObjectSymmetryOptions options;
  options.min_axis_probability = 0.2;
  options.min_plane_probability = 0.5;
  const ListedSymmetries listed = list_symmetries(likely_and_unlikely(), options);
  EXPECT_EQ(listed.rotational.size(), 1U);
  ASSERT_EQ(listed.reflectional.size(), 1U);
  EXPECT_EQ(listed.reflectional[0].plane.normal, Eigen::Vector3d::UnitX());
  options.min_axis_probability = options.min_plane_probability = 1.0;
  const ListedSymmetries none = list_symmetries(likely_and_unlikely(), options);
  EXPECT_TRUE(none.rotational.empty());
  EXPECT_TRUE(none.reflectional.empty());
}

/// An object that is all of a scene's points.
struct WholeScene {
  explicit WholeScene(PointCloud points) : cloud(std::move(points)) {
    object.points = testing::all_of(cloud);
    object.score = 0.9;
  }
  SymmetryCandidates candidates(const SymmetrySearchOptions& options) const {
    return symmetry_candidates({cloud, field, table}, object, options);
  }

  PointCloud cloud;
  DistanceField field = testing::all_seen(cloud);
  std::optional<Plane> table = Plane{Eigen::Vector3d::UnitZ(), 0.0};
  SearchedObject object;
};

TEST(SymmetryCandidates, OfABoxAreItsThreePlanesComparedWithOneAnother) {
  const WholeScene scene(testing::box({0.1, 0.16, 0.21}));
  const SymmetryCandidates found = scene.candidates({});
  ASSERT_GE(found.planes.size(), 3U);
  double last = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const PlaneFeatures& features = found.planes[k].features;
    EXPECT_GT(found.planes[k].probability, 0.5);
    EXPECT_GE(features.images.plane_residual(), last);
    last = features.images.plane_residual();
    EXPECT_EQ(features.rank, static_cast<double>(k));
    EXPECT_NEAR(features.nearest, radians(90.0), radians(2.0));
    EXPECT_NEAR(features.off_square, k == 0 ? -1.0 : 0.0, 0.03);
    EXPECT_EQ(features.best_matched, found.planes[0].features.images.matched);
    EXPECT_EQ(features.along_axis, -1.0);
  }
  for (std::size_t k = 3; k < found.planes.size(); ++k) EXPECT_LT(found.planes[k].probability, 0.5);
}

TEST(SymmetryCandidates, OfAVaseAreItsAxisWithoutThePlanesThatItImplies) {
  const WholeScene scene(testing::vase());
  SymmetrySearchOptions options;
  const SymmetryCandidates found = scene.candidates(options);
  ASSERT_TRUE(found.axis);
  EXPECT_GT(found.axis->probability, 0.5);
  EXPECT_LT(line_angle(found.axis->axis.direction, Eigen::Vector3d::UnitZ()), radians(1.0));
  for (const PlaneCandidate& plane : found.planes)
    EXPECT_GT(plane.features.along_axis, std::sin(options.object_symmetry.plane_in_axis_angle));
  options.rotational_stream = false;
  const SymmetryCandidates planes_alone = scene.candidates(options);
  EXPECT_FALSE(planes_alone.axis);
  EXPECT_GT(planes_alone.planes.size(), found.planes.size());
}

bool has_level_plane(const SymmetryCandidates& found, double height) {
  return std::any_of(found.planes.begin(), found.planes.end(), [&](const PlaneCandidate& each) {
    return line_angle(each.plane.normal, Eigen::Vector3d::UnitZ()) < radians(1.0) &&
           std::abs(each.plane.signed_distance({0.0, 0.0, height})) < 0.003;
  });
}

TEST(SymmetryCandidates, OfABoxOnTheTableHoldALevelPlaneHalfWayUp) {
  // Its top and two sides are seen, from 2 cm above the table on: nothing is aligned upside down.
  const PointCloud box = testing::box({0.1, 0.16, 0.12});
  PointIndices seen;
  for (Index i = 0; i < box.size(); ++i) {
    if (box.position(i).z() > 0.02F && box.normal(i).dot(Eigen::Vector3f(1, 1, 1)) > 0.0F)
      seen.push_back(i);
  }
  WholeScene scene(select(box, seen));
  scene.field = testing::nothing_known(scene.cloud);
  EXPECT_TRUE(has_level_plane(scene.candidates({}), 0.06));
  scene.table.reset();
  EXPECT_FALSE(has_level_plane(scene.candidates({}), 0.06));
}

TEST(ObjectSymmetryOptions, RefuseValuesOutOfRange) {
  for (const auto& spoil : std::vector<std::function<void(ObjectSymmetryOptions&)>>{
           [](auto& o) { o.min_plane_probability = 1.5; },
           [](auto& o) { o.min_axis_probability = -0.1; },
           [](auto& o) { o.min_axis_coverage = 1.2; }, [](auto& o) { o.max_axis_residual = 2.0; },
           [](auto& o) { o.plane_features.max_image_offset = -0.001; }}) {
    ObjectSymmetryOptions options;
    spoil(options);
    EXPECT_THROW(options.validate(), InputError);
  }
}

}  // namespace
}  // namespace symscene
