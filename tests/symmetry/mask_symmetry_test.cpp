#include "symmetry/mask_symmetry.hpp"

#include <gtest/gtest.h>

#include "surfaces.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

MeasuredSymmetries likely_and_unlikely() {
  MeasuredSymmetries measured;
  measured.axis = MeasuredAxis{{}, {}, 0.3};
  const Eigen::Vector3d here = Eigen::Vector3d::Zero();
  measured.planes.push_back({{here, Eigen::Vector3d::UnitX()}, {}, 0.9});
  measured.planes.push_back({{here, Eigen::Vector3d::UnitY()}, {}, 0.4});
  return measured;
}

TEST(ListSymmetries, ThatAreProbableEnough) {
  SceneObject object;
  object.rotational.resize(2);
  object.reflectional.resize(2);
  ObjectSymmetryBounds bounds;
  bounds.min_axis_probability = 0.2;
  bounds.min_plane_probability = 0.5;
  list_symmetries(likely_and_unlikely(), bounds, object);
  EXPECT_EQ(object.rotational.size(), 1U);
  ASSERT_EQ(object.reflectional.size(), 1U);
  EXPECT_EQ(object.reflectional[0].plane.normal, Eigen::Vector3d::UnitX());
  bounds.min_axis_probability = bounds.min_plane_probability = 1.0;
  list_symmetries(likely_and_unlikely(), bounds, object);
  EXPECT_TRUE(object.rotational.empty());
  EXPECT_TRUE(object.reflectional.empty());
}

/// An object that is all of a scene's points.
struct WholeScene {
  explicit WholeScene(PointCloud points) : cloud(std::move(points)) {
    object.points = testing::all_of(cloud);
    object.score = 0.9;
  }
  MeasuredSymmetries measure(const WholeObjectOptions& options) const {
    return measure_symmetries({cloud, field, table}, options, object);
  }

  PointCloud cloud;
  DistanceField field = testing::all_seen(cloud);
  std::optional<Plane> table = Plane{Eigen::Vector3d::UnitZ(), 0.0};
  SceneObject object;
};

TEST(MeasureSymmetries, OfABoxAreItsThreePlanesComparedWithOneAnother) {
  const WholeScene scene(testing::box({0.1, 0.16, 0.21}));
  const MeasuredSymmetries found = scene.measure({});
  ASSERT_GE(found.planes.size(), 3U);
  double last = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const PlaneFeatures& features = found.planes[k].features;
    EXPECT_GT(found.planes[k].probability, 0.5);
    EXPECT_GE(features.misfit(), last);
    last = features.misfit();
    EXPECT_EQ(features.rank, static_cast<double>(k));
    EXPECT_NEAR(features.nearest, radians(90.0), radians(2.0));
    EXPECT_NEAR(features.off_square, k == 0 ? -1.0 : 0.0, 0.03);
    EXPECT_EQ(features.best_matched, found.planes[0].features.matched);
    EXPECT_EQ(features.along_axis, -1.0);
  }
  for (std::size_t k = 3; k < found.planes.size(); ++k) EXPECT_LT(found.planes[k].probability, 0.5);
}

TEST(MeasureSymmetries, OfAVaseAreItsAxisWithoutThePlanesThatFollowFromIt) {
  const WholeScene scene(testing::vase());
  WholeObjectOptions options;
  const MeasuredSymmetries found = scene.measure(options);
  ASSERT_TRUE(found.axis);
  EXPECT_GT(found.axis->probability, 0.5);
  EXPECT_LT(line_angle(found.axis->axis.direction, Eigen::Vector3d::UnitZ()), radians(1.0));
  for (const MeasuredPlane& plane : found.planes)
    EXPECT_GT(plane.features.along_axis, std::sin(options.bounds.plane_in_axis_angle));
  options.rotational_stream = false;
  const MeasuredSymmetries planes_alone = scene.measure(options);
  EXPECT_FALSE(planes_alone.axis);
  EXPECT_GT(planes_alone.planes.size(), found.planes.size());
}

TEST(MeasureSymmetries, RefusesBoundsOutOfRange) {
  for (const auto& spoil : std::vector<std::function<void(ObjectSymmetryBounds&)>>{
           [](auto& b) { b.min_plane_probability = 1.5; },
           [](auto& b) { b.min_axis_probability = -0.1; },
           [](auto& b) { b.min_axis_coverage = 1.2; }, [](auto& b) { b.max_axis_misfit = 2.0; },
           [](auto& b) { b.max_image_offset = -0.001; }}) {
    ObjectSymmetryBounds bounds;
    spoil(bounds);
    EXPECT_THROW(bounds.validate(), InputError);
  }
}

}  // namespace
}  // namespace symscene
