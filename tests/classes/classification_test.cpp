#include "symscene/classes/classification.hpp"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "classes/classification_among.hpp"
#include "classes/surface_fit.hpp"
#include "core/random.hpp"
#include "surfaces.hpp"
#include "symscene/core/error.hpp"

namespace symscene::testing {
namespace {

const std::vector<ObjectAxis> no_axes;
const std::vector<ObjectPlane> no_planes;
const std::optional<Plane> no_table;

/// The class of points about which nothing else is known.
ObjectClass class_of(const PointCloud& cloud, double spacing = 0.005) {
  const DistanceField field = nothing_known(cloud);
  return classify({cloud, spacing, no_axes, no_planes, field, no_table});
}

PointCloud ball(double radius) {
  std::vector<ProfilePoint> profile;
  constexpr int steps = 48;
  for (int k = 0; k <= steps; ++k) {
    const double angle = std::numbers::pi * k / steps;
    profile.push_back(
        {k == 0 || k == steps ? 0.0 : radius * std::sin(angle), radius * (1.0 - std::cos(angle))});
  }
  return as_cloud(make_revolution(profile, 96, 0.005));
}

PointCloud can(double radius, double height) {
  const std::array<ProfilePoint, 4> profile = {
      {{0.0, 0.0}, {radius, 0.0}, {radius, height}, {0.0, height}}};
  return as_cloud(make_revolution(profile, 96, 0.005));
}

PointCloud hexagonal_prism(double apothem, double height) {
  const double corner = apothem / std::cos(std::numbers::pi / 6);
  const std::array<ProfilePoint, 4> profile = {
      {{0.0, 0.0}, {corner, 0.0}, {corner, height}, {0.0, height}}};
  return as_cloud(make_revolution(profile, 6, 0.5));
}

/// Independent errors along the normals.
PointCloud noisy(PointCloud cloud, double deviation, std::uint64_t seed) {
  Random random(seed);
  for (Index i = 0; i < cloud.size(); ++i) {
    const auto error = static_cast<float>(deviation * random.normal());
    cloud.positions.row(i) += error * cloud.normals.row(i);
  }
  return cloud;
}

double value_of(const ObjectClass& found, const std::string& name) {
  for (const Dimension& dimension : found.dimensions) {
    if (dimension.name == name) return dimension.value;
  }
  ADD_FAILURE() << "no " << name;
  return 0.0;
}

TEST(Classification, OfABallIsASphereOfItsRadius) {
  const ObjectClass found = class_of(noisy(ball(0.04), 0.0005, 1));
  ASSERT_EQ(found.kind, SymmetryClass::sphere);
  EXPECT_NEAR(value_of(found, "radius"), 0.04, 0.0005);
  EXPECT_LT((found.center - Eigen::Vector3d(0, 0, 0.04)).norm(), 0.0005);
}

TEST(Classification, OfACanIsACylinderOfItsDimensions) {
  const ObjectClass found = class_of(noisy(can(0.035, 0.12), 0.0005, 1));
  ASSERT_EQ(found.kind, SymmetryClass::cylinder);
  EXPECT_NEAR(value_of(found, "radius"), 0.035, 0.0005);
  EXPECT_NEAR(value_of(found, "height"), 0.12, 0.0005);
}

TEST(Classification, OfABoxHasItsDimensionsAndExactlyPerpendicularPlanes) {
  const ObjectClass found = class_of(noisy(box({0.16, 0.06, 0.22}), 0.0005, 1));
  ASSERT_EQ(found.kind, SymmetryClass::box);
  EXPECT_NEAR(value_of(found, "length"), 0.22, 0.0006);
  EXPECT_NEAR(value_of(found, "width"), 0.16, 0.0006);
  EXPECT_NEAR(value_of(found, "height"), 0.06, 0.0006);
  EXPECT_LT((found.axes.transpose() * found.axes - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

TEST(Classification, OfAHexagonalPrismIsSixFold) {
  const ObjectClass found = class_of(noisy(hexagonal_prism(0.04, 0.12), 0.0005, 1));
  ASSERT_EQ(found.kind, SymmetryClass::n_fold);
  EXPECT_EQ(found.order, 6);
  EXPECT_NEAR(value_of(found, "apothem"), 0.04, 0.0006);
}

TEST(Classification, OfAVaseIsNotASurfaceOfFewParameters) {
  EXPECT_EQ(class_of(noisy(vase(), 0.0005, 1)).kind, SymmetryClass::none);
}

TEST(Classification, TakesTheClassOfListedSymmetriesWhereNoSurfaceExplainsThePoints) {
  const PointCloud cloud = noisy(vase(), 0.0005, 1);
  const DistanceField field = nothing_known(cloud);
  const std::vector<ObjectAxis> axes = {
      {{{0.003, 0, 0}, Eigen::Vector3d(0.03, 0, 1).normalized()}, 0.01}};
  const ObjectClass found = classify({cloud, 0.005, axes, no_planes, field, no_table});
  ASSERT_EQ(found.kind, SymmetryClass::revolution);
  EXPECT_LT(line_angle(found.axes.col(2), Eigen::Vector3d::UnitZ()), radians(0.5));
  EXPECT_TRUE(found.dimensions.empty());
}

TEST(Classification, FitsNearlyPerpendicularPlanesInOneFrame) {
  // An ellipsoid has three planes but is no box.
  const std::array<Ellipsoid, 1> parts = {{{{0, 0, 0.1}, {0.09, 0.06, 0.04}}}};
  const PointCloud cloud = as_cloud(make_mirrored_body(parts, 0.002, 0.004));
  const DistanceField field = nothing_known(cloud);
  const auto near = [](double x, double y, double z) {
    return ObjectPlane{{{0.001, 0.0, 0.1}, Eigen::Vector3d(x, y, z).normalized()}, 0.02};
  };
  const std::vector<ObjectPlane> planes = {near(1, 0.05, 0.0), near(0.03, 1, 0.02),
                                           near(0.0, 0.04, 1)};
  const ObjectClass found = classify({cloud, 0.005, no_axes, planes, field, no_table});
  ASSERT_EQ(found.kind, SymmetryClass::box);
  EXPECT_LT((found.axes.transpose() * found.axes - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_LT(line_angle(found.axes.col(0), Eigen::Vector3d::UnitX()), radians(0.7));
  EXPECT_LT((found.center - Eigen::Vector3d(0, 0, 0.1)).norm(), 0.001);
}

TEST(Classification, MovesAndScalesWithThePoints) {
  const PointCloud cloud = noisy(box({0.16, 0.06, 0.22}), 0.0005, 1);
  const ObjectClass before = class_of(cloud);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()));
  motion.pretranslate(Eigen::Vector3d(0.3, -0.2, 0.7));
  PointCloud large = moved(cloud, motion);
  large.positions *= 3.0F;
  const ObjectClass after = class_of(large, 0.015);
  ASSERT_EQ(after.kind, before.kind);
  EXPECT_LT((after.center - 3.0 * (motion * before.center)).norm(), 1e-4);
  for (int k = 0; k < 3; ++k) {
    EXPECT_LT(line_angle(after.axes.col(k), motion.linear() * before.axes.col(k)), 1e-4);
    EXPECT_NEAR(after.dimensions[static_cast<std::size_t>(k)].value,
                3.0 * before.dimensions[static_cast<std::size_t>(k)].value, 1e-4);
  }
}

/// What a camera above and before a box sees of it.
PointCloud seen_faces() {
  const PointCloud surface = sample_surface(make_box({0.16, 0.06, 0.22}, 0.005), 60000);
  return voxel_downsample(seen_from(surface, {1.0F, 0.0F, 1.5F}), 0.005);
}

TEST(Classification, GivesALowerBoundForAnEndThatIsHidden) {
  const ObjectClass found = class_of(seen_faces());
  ASSERT_EQ(found.kind, SymmetryClass::box);
  for (const Dimension& dimension : found.dimensions) {
    EXPECT_FALSE(dimension.sigma) << dimension.name;
    EXPECT_EQ(dimension.reason, "an end is hidden");
    EXPECT_LE(dimension.value, 0.222);
  }
}

TEST(Classification, BoundsAHiddenEndByAllThatIsSeen) {
  // An occluder cuts the long face on three quarters of its width, so that most strips are short.
  PointIndices seen;
  const PointCloud faces = seen_faces();
  for (Index i = 0; i < faces.size(); ++i) {
    const Eigen::Vector3f p = faces.position(i);
    if (p.y() < -0.015F || p.z() > 0.12F) seen.push_back(i);
  }
  const ObjectClass found = class_of(select(faces, seen));
  ASSERT_EQ(found.kind, SymmetryClass::box);
  EXPECT_FALSE(found.dimensions[0].sigma);
  EXPECT_GT(value_of(found, "length"), 0.215);
  EXPECT_LT(value_of(found, "length"), 0.222);
}

TEST(Classification, OfABoxThatItsObjectLeavesIsNotThatBox) {
  // A thin rod beyond the end of a box has few of the points.
  const PointCloud crate = box({0.1, 0.1, 0.1});
  const PointCloud rod =
      moved(box({0.4, 0.006, 0.006}), Eigen::Isometry3d(Eigen::Translation3d(0.25, 0.0, 0.05)));
  ASSERT_LT(static_cast<double>(rod.size()), 0.15 * static_cast<double>(crate.size()));
  EXPECT_FALSE(class_of(crate).dimensions.empty());
  EXPECT_TRUE(class_of(joined(crate, rod)).dimensions.empty());
}

/// A can of which the last points are at a height above the table z = 0.
PointCloud can_seen_from(double lowest) {
  PointIndices seen;
  const PointCloud whole = noisy(can(0.035, 0.12), 0.0003, 1);
  for (Index i = 0; i < whole.size(); ++i) {
    if (whole.position(i).z() > static_cast<float>(lowest)) seen.push_back(i);
  }
  return select(whole, seen);
}

const Dimension& height_of(const ObjectClass& found) { return found.dimensions.back(); }

TEST(Classification, OfACanOnTheTableHasItsHeightAboveIt) {
  const PointCloud seen = can_seen_from(0.008);
  const DistanceField field = nothing_known(seen);
  const std::optional<Plane> table = Plane{{0, 0, 1}, 0.0};
  const ObjectClass found = classify({seen, 0.005, no_axes, no_planes, field, table});
  ASSERT_EQ(found.kind, SymmetryClass::cylinder);
  ASSERT_TRUE(height_of(found).sigma);
  EXPECT_LT(*height_of(found).sigma, 0.002);
  EXPECT_NEAR(height_of(found).value, 0.12, 0.001);
}

TEST(Classification, KnowsLessOfAHeightTheFartherTheLastPointsAreFromTheTable) {
  const PointCloud seen = can_seen_from(0.017);
  const DistanceField field = nothing_known(seen);
  const std::optional<Plane> table = Plane{{0, 0, 1}, 0.0};
  const ObjectClass found = classify({seen, 0.005, no_axes, no_planes, field, table});
  ASSERT_EQ(found.kind, SymmetryClass::cylinder);
  ASSERT_TRUE(height_of(found).sigma);
  EXPECT_GT(*height_of(found).sigma, 0.005);
}

TEST(Classification, OfACanInABowlHasNoHeightAboveTheTable) {
  // The rim of the bowl hides the foot of the can on all but a third of its turn.
  const PointCloud whole = can_seen_from(0.008);
  PointIndices visible;
  for (Index i = 0; i < whole.size(); ++i) {
    const Eigen::Vector3f p = whole.position(i);
    if (p.x() > 0.02F || p.z() > 0.04F) visible.push_back(i);
  }
  const PointCloud seen = select(whole, visible);
  const DistanceField field = nothing_known(seen);
  const std::optional<Plane> table = Plane{{0, 0, 1}, 0.0};
  const ClassifiedObject object{seen, 0.005, no_axes, no_planes, field, table};
  ASSERT_TRUE(height_of(classify(object)).sigma);
  // The floor of the bowl around the can, 8 mm above the table.
  PointIndices floor;
  const PointCloud ring =
      moved(can(0.06, 0.01), Eigen::Isometry3d(Eigen::Translation3d(0, 0, -0.002)));
  for (Index i = 0; i < ring.size(); ++i) {
    if (ring.normal(i).z() > 0.9F && ring.position(i).head<2>().norm() > 0.036F) floor.push_back(i);
  }
  const ObjectClass found = classify_among(object, select(ring, floor), {});
  ASSERT_EQ(found.kind, SymmetryClass::cylinder);
  EXPECT_FALSE(height_of(found).sigma);
  EXPECT_LT(height_of(found).value, 0.1205);
}

TEST(Classification, FindsTheEndsOfFacesInFreeSpace) {
  const PointCloud seen = seen_faces();
  const DistanceField field = all_seen(seen);
  ClassOptions options;
  options.max_empty = 1.0;  // this field calls the hidden side empty
  const ObjectClass found = classify({seen, 0.005, no_axes, no_planes, field, no_table}, options);
  ASSERT_EQ(found.kind, SymmetryClass::box);
  for (const Dimension& dimension : found.dimensions) {
    ASSERT_TRUE(dimension.sigma) << dimension.name;
    EXPECT_LT(*dimension.sigma, 0.005);
  }
  EXPECT_NEAR(value_of(found, "length"), 0.22, 0.003);
  EXPECT_NEAR(value_of(found, "width"), 0.16, 0.003);
  EXPECT_NEAR(value_of(found, "height"), 0.06, 0.003);
}

TEST(Classification, CountsPointsOfANeighbourAsUnexplained) {
  PointCloud beside =
      moved(box({0.02, 0.02, 0.03}), Eigen::Isometry3d(Eigen::Translation3d(0.1, 0, 0)));
  const ObjectClass found = class_of(noisy(joined(can(0.035, 0.12), beside), 0.0003, 1));
  ASSERT_EQ(found.kind, SymmetryClass::cylinder);
  EXPECT_LT(found.explained, 0.97);
  EXPECT_NEAR(value_of(found, "radius"), 0.035, 0.001);
}

TEST(Classification, OfANarrowStripIsNoCylinder) {
  // A tenth of a turn of a can: the radius is hardly constrained.
  PointIndices strip;
  const PointCloud whole = noisy(can(0.05, 0.06), 0.0008, 1);
  for (Index i = 0; i < whole.size(); ++i) {
    if (std::abs(std::atan2(whole.position(i).y(), whole.position(i).x())) < 0.3F &&
        std::abs(whole.normal(i).z()) < 0.5F)
      strip.push_back(i);
  }
  ASSERT_GT(strip.size(), 40U);
  EXPECT_TRUE(class_of(select(whole, strip)).dimensions.empty());
}

TEST(Classification, RefusesOptionsOutOfRange) {
  ClassOptions options;
  options.min_explained = 2.0;
  const PointCloud cloud = ball(0.04);
  const DistanceField field = nothing_known(cloud);
  EXPECT_THROW(classify({cloud, 0.005, no_axes, no_planes, field, no_table}, options), InputError);
}

/// With independent errors the covariance of the fit alone holds: 68 % within one deviation.
TEST(SurfaceFit, HasTheDeviationOfIndependentErrors) {
  const PointCloud exact = can(0.035, 0.12);
  constexpr int trials = 200;
  int within = 0;
  double mean = 0.0;
  std::vector<std::pair<double, double>> radii;
  for (int trial = 0; trial < trials; ++trial) {
    const FitSamples samples =
        fit_samples(noisy(exact, 0.001, static_cast<std::uint64_t>(trial)), 400);
    SurfaceModel start;
    start.kind = SurfaceModel::Kind::cylinder;
    start.size = 0.034;
    start.origin = {0.001, 0, 0.06};
    const FitBounds bounds;
    place_planar_faces(start, samples, bounds);
    const auto fit = fit_surface(start, samples, bounds);
    ASSERT_TRUE(fit);
    radii.emplace_back(fit->model.size, std::sqrt(fit->covariance(6, 6)));
    mean += fit->model.size / trials;
  }
  for (const auto& [radius, sigma] : radii) within += std::abs(radius - mean) < sigma ? 1 : 0;
  EXPECT_GT(within, 0.58 * trials);
  EXPECT_LT(within, 0.78 * trials);
  EXPECT_NEAR(mean, 0.035, 0.0002);
}

}  // namespace
}  // namespace symscene::testing
