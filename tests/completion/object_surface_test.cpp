#include "symscene/completion/object_surface.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "core/rigid_motion.hpp"
#include "surfaces.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/neighbors.hpp"

namespace symscene {
namespace {

constexpr float voxel = 0.005F;  // of the occupancy [m]

/// What is known of an object, and what its closed surface is made of.
struct Known {
  PointCloud observed;
  std::vector<ObjectAxis> axes = {};
  std::vector<ObjectPlane> planes = {};
  DistanceField field = {};
  std::optional<Plane> table = std::nullopt;
};

DistanceField nothing_seen(const PointCloud& cloud, const std::optional<Plane>& table) {
  const Box box = cloud.empty() ? Box{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()}
                                : bounding_box(cloud.positions);
  return unknown_distance_field(box.padded(0.2F), voxel, table);
}

ObjectSurface closed(const Known& known) {
  const PointCloud added =
      complete_object(known.observed, known.axes, known.planes, known.field, {});
  return object_surface({known.observed, added, known.axes, known.planes},
                        {known.field, known.table});
}

ObjectSurface closed_where_nothing_is_seen(Known known) {
  known.field = nothing_seen(known.observed, known.table);
  return closed(known);
}

/// Every edge runs once in each direction, so that it has exactly two triangles, and no triangle is
/// degenerate.
void expect_watertight(const TriangleMesh& mesh) {
  std::map<std::pair<Index, Index>, int> edges;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    for (Eigen::Index k = 0; k < 3; ++k)
      ++edges[{mesh.triangles(t, k), mesh.triangles(t, (k + 1) % 3)}];
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.contains({edge.second, edge.first}));
    ASSERT_NE(edge.first, edge.second);
    ASSERT_NE(mesh.vertices.row(edge.first), mesh.vertices.row(edge.second));
  }
}

/// A ball that touches z = 0.
PointCloud ball(double radius) {
  std::vector<ProfilePoint> profile;
  for (int k = 0; k <= 48; ++k) {
    const double angle = std::numbers::pi * k / 48;
    profile.push_back(
        {k == 0 || k == 48 ? 0.0 : radius * std::sin(angle), radius * (1.0 - std::cos(angle))});
  }
  return testing::as_cloud(make_revolution(profile, 96, 0.01));
}

PointCloud cylinder(double radius, double height) {
  const std::array<ProfilePoint, 4> profile{
      ProfilePoint{0.0, 0.0}, {radius, 0.0}, {radius, height}, {0.0, height}};
  return testing::as_cloud(make_revolution(profile, 96, 0.005));
}

/// The points before x = 0.
PointCloud front_half(const PointCloud& cloud) {
  PointIndices half;
  for (Index i = 0; i < cloud.size(); ++i) {
    if (cloud.positions(i, 0) >= 0.0F) half.push_back(i);
  }
  return select(cloud, half);
}

const ObjectAxis upright{RotationAxis{}, 0.0};
const ObjectPlane across_x{{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}, 0.0};

TEST(ObjectSurface, OfAHalfSeenBallWithAnAxisHasItsVolume) {
  const ObjectSurface surface =
      closed_where_nothing_is_seen({.observed = front_half(ball(0.04)), .axes = {upright}});
  expect_watertight(surface.mesh);
  const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(0.04, 3);
  EXPECT_NEAR(solid_properties(surface.mesh).volume / volume, 1.0, 0.03);
}

TEST(ObjectSurface, OfAHalfSeenBallWithAPlaneHasItsVolumeAndCentre) {
  const ObjectSurface surface =
      closed_where_nothing_is_seen({.observed = front_half(ball(0.04)), .planes = {across_x}});
  expect_watertight(surface.mesh);
  const SolidProperties solid = solid_properties(surface.mesh);
  EXPECT_NEAR(solid.volume / (4.0 / 3.0 * std::numbers::pi * std::pow(0.04, 3)), 1.0, 0.03);
  EXPECT_LT((solid.centre_of_mass - Eigen::Vector3d(0, 0, 0.04)).norm(), 0.001);
}

TEST(ObjectSurface, OfAHalfSeenBoxHasItsVolumeAndPrincipalAxes) {
  const ObjectSurface surface = closed_where_nothing_is_seen(
      {.observed = front_half(testing::box({0.1, 0.14, 0.08})), .planes = {across_x}});
  expect_watertight(surface.mesh);
  const SolidProperties solid = solid_properties(surface.mesh);
  EXPECT_NEAR(solid.volume / (0.1 * 0.14 * 0.08), 1.0, 0.03);
  EXPECT_GT(std::abs(solid.principal_axes(1, 0)), 0.999);  // the longest edge, y, first
  EXPECT_GT(std::abs(solid.principal_axes(2, 2)), 0.999);
}

TEST(ObjectSurface, OfAHalfSeenCylinderHasItsVolume) {
  const ObjectSurface surface = closed_where_nothing_is_seen(
      {.observed = front_half(cylinder(0.035, 0.12)), .axes = {upright}});
  expect_watertight(surface.mesh);
  const double volume = std::numbers::pi * 0.035 * 0.035 * 0.12;
  EXPECT_NEAR(solid_properties(surface.mesh).volume / volume, 1.0, 0.03);
}

TEST(ObjectSurface, OfAThinWallIsHollow) {
  const std::array<ProfilePoint, 6> profile{ProfilePoint{0.0, 0.0}, {0.04, 0.0},    {0.04, 0.1},
                                            {0.036, 0.1},           {0.036, 0.006}, {0.0, 0.006}};
  const TriangleMesh cup = make_revolution(profile, 96, 0.004);
  const ObjectSurface surface = closed_where_nothing_is_seen({.observed = testing::as_cloud(cup)});
  expect_watertight(surface.mesh);
  const double volume = solid_properties(cup).volume;
  EXPECT_NEAR(solid_properties(surface.mesh).volume / volume, 1.0, 0.25);
}

/// The lower half of the cavity and the floor are hidden; the walls above tell that it is a vessel.
TEST(ObjectSurface, OfACupIsHollowWhereItsInsideIsHidden) {
  const std::array<ProfilePoint, 6> profile{ProfilePoint{0.0, 0.0}, {0.04, 0.0},    {0.04, 0.1},
                                            {0.036, 0.1},           {0.036, 0.006}, {0.0, 0.006}};
  const TriangleMesh cup = make_revolution(profile, 96, 0.004);
  const PointCloud whole = testing::as_cloud(cup);
  PointIndices seen;
  for (Index i = 0; i < whole.size(); ++i) {
    const float radius = std::hypot(whole.positions(i, 0), whole.positions(i, 1));
    const bool outer = radius > 0.038F && whole.positions(i, 2) > 0.005F;
    if (outer || whole.positions(i, 2) > 0.05F) seen.push_back(i);
  }
  const ObjectSurface surface =
      closed_where_nothing_is_seen({.observed = select(whole, seen), .table = Plane{}});
  expect_watertight(surface.mesh);
  const double volume = solid_properties(cup).volume, filled = std::numbers::pi * 1.6e-3 * 0.05;
  EXPECT_LT(solid_properties(surface.mesh).volume, 1.5 * volume);
  EXPECT_LT(solid_properties(surface.mesh).volume, 0.6 * (volume + filled));
}

/// Without a symmetry: top and front of a box on a table.
TEST(ObjectSurface, WithoutASymmetryReachesDownToTheTable) {
  const PointCloud whole = testing::box({0.1, 0.14, 0.08});
  PointIndices seen;
  for (Index i = 0; i < whole.size(); ++i) {
    if (whole.normals(i, 0) > 0.5F || whole.normals(i, 2) > 0.5F) seen.push_back(i);
  }
  const ObjectSurface surface =
      closed_where_nothing_is_seen({.observed = select(whole, seen), .table = Plane{}});
  expect_watertight(surface.mesh);
  EXPECT_NEAR(solid_properties(surface.mesh).volume / (0.1 * 0.14 * 0.08), 1.0, 0.05);
  EXPECT_GT(surface.mesh.vertices.col(2).minCoeff(), -1e-4F);
}

/// The mean distance of the points of one cloud from another.
double mean_distance(const Points& points, const Points& others) {
  const CellList cells(others, 0.01F);
  double sum = 0.0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    sum += std::sqrt(double{cells.nearest(points.row(i).transpose(), 0.1F).second});
  return sum / static_cast<double>(points.rows());
}

TEST(ObjectSurface, MovesWithTheObjectUpToTheResolution) {
  Known known{.observed = testing::seen_from(testing::vase(), {1.0F, 0.2F, 0.7F}),
              .axes = {upright},
              .table = Plane{}};
  const TriangleMesh still = closed_where_nothing_is_seen(known).mesh;
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.translate(Eigen::Vector3d(0.311, -0.127, 0.533));
  motion.rotate(Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 3, 2).normalized()));
  known.observed = transformed(known.observed, motion);
  known.axes = {{{motion.translation(), motion.linear().col(2)}, 0.0}};
  known.table = transformed(*known.table, motion);
  const TriangleMesh moved = closed_where_nothing_is_seen(known).mesh;
  expect_watertight(moved);
  const TriangleMesh back = transformed(moved, motion.inverse());
  EXPECT_LT(mean_distance(still.vertices, back.vertices), 0.0025);
  EXPECT_LT(mean_distance(back.vertices, still.vertices), 0.0025);
  const SolidProperties a = solid_properties(still), b = solid_properties(back);
  EXPECT_NEAR(a.volume / b.volume, 1.0, 0.02);
  EXPECT_LT((a.centre_of_mass - b.centre_of_mass).norm(), 0.001);
}

/// Space around a ball, of which the half behind x = 0 was not seen.
DistanceField half_seen(const PointCloud& cloud, double radius) {
  OccupancyGrid grid = rasterize(OccupancyMap{}, bounding_box(cloud.positions).padded(0.1F));
  std::size_t at = 0;
  for (int z = 0; z < grid.frame.size.z(); ++z) {
    for (int y = 0; y < grid.frame.size.y(); ++y) {
      for (int x = 0; x < grid.frame.size.x(); ++x, ++at) {
        const Eigen::Vector3f p =
            grid.frame.origin +
            grid.frame.resolution * (Eigen::Vector3f(static_cast<float>(x), static_cast<float>(y),
                                                     static_cast<float>(z)) +
                                     Eigen::Vector3f::Constant(0.5F));
        const double outside =
            double{(p - Eigen::Vector3f(0.0F, 0.0F, static_cast<float>(radius))).norm()} - radius;
        if (p.x() > 0.0F && outside > 0.003) grid.states[at] = VoxelState::free;
      }
    }
  }
  return distance_field(grid, std::nullopt);
}

TEST(ObjectSurface, HasNoVertexMoreThanAVoxelInsideSeenEmptySpace) {
  const PointCloud whole = ball(0.04);
  Known known{.observed = front_half(whole), .field = half_seen(whole, 0.04)};
  // An axis that is wrong by 2 cm has images in space that was seen empty.
  known.axes = {{{Eigen::Vector3d(0.02, 0, 0), Eigen::Vector3d::UnitZ()}, 0.0}};
  for (const bool symmetric : {true, false}) {
    if (!symmetric) known.axes.clear();
    const ObjectSurface surface = closed(known);
    expect_watertight(surface.mesh);
    ASSERT_GT(surface.mesh.vertices.rows(), 0);
    for (Eigen::Index v = 0; v < surface.mesh.vertices.rows(); ++v)
      ASSERT_LE(known.field.at(surface.mesh.vertices.row(v).transpose()), 1.001F * voxel);
  }
}

PointCloud behind_the_ball() {
  PointCloud spike;
  spike.positions.resize(1, 3);
  spike.positions << -0.12F, 0.0F, 0.04F;
  spike.normals.resize(1, 3);
  spike.normals << -1.0F, 0.0F, 0.0F;
  return spike;
}

/// A point far behind the hidden half of a ball spans a cone in its convex hull. The image of the
/// space that was seen empty before the ball cuts most of the cone off.
class BallWithASpike {
 public:
  /// How far the surface reaches behind x = 0. [m]
  float length(const std::vector<ObjectPlane>& planes, double image_tolerance) const {
    ObjectSurfaceOptions options;
    options.image_tolerance = image_tolerance;
    const PointCloud nothing;
    const std::optional<Plane> no_table;
    const ObjectSurface surface =
        object_surface({observed_, nothing, {}, planes}, {field_, no_table}, options);
    expect_watertight(surface.mesh);
    return -surface.mesh.vertices.col(0).minCoeff();
  }

 private:
  PointCloud whole_ = ball(0.04);
  PointCloud observed_ = testing::joined(front_half(whole_), behind_the_ball());
  DistanceField field_ = half_seen(testing::joined(whole_, behind_the_ball()), 0.04);
};

TEST(ObjectSurface, EndsWhereAnImageOfItWasSeenEmpty) {
  const BallWithASpike object;
  EXPECT_GT(object.length({}, 0.0075), 0.1F);
  EXPECT_LT(object.length({across_x}, 0.0075), 0.06F);  // the radius, the tolerance, two voxels
}

TEST(ObjectSurface, ImagesOfEmptySpaceAreNoMoreExactThanItsVoxels) {
  const BallWithASpike object;
  EXPECT_EQ(object.length({across_x}, 0.0), object.length({across_x}, 1.5 * double{voxel}));
  EXPECT_LT(object.length({across_x}, 0.0), object.length({across_x}, 0.02));
}

TEST(ObjectSurface, TellsObservedFromInferredTriangles) {
  const ObjectSurface surface = closed_where_nothing_is_seen(
      {.observed = front_half(testing::box({0.1, 0.14, 0.08})), .planes = {across_x}});
  ASSERT_EQ(static_cast<Eigen::Index>(surface.observed.size()), surface.mesh.triangles.rows());
  for (Eigen::Index t = 0; t < surface.mesh.triangles.rows(); ++t) {
    float x = 0.0F;
    for (Eigen::Index k = 0; k < 3; ++k)
      x += surface.mesh.vertices(surface.mesh.triangles(t, k), 0);
    const bool is_observed = surface.observed[static_cast<std::size_t>(t)] != 0;
    EXPECT_TRUE(is_observed || x / 3.0F < 0.002F);
    EXPECT_TRUE(!is_observed || x / 3.0F > -0.01F);
  }
}

TEST(ObjectSurface, OfNothingIsEmptyAndOfFewOrFlatPointsIsClosed) {
  EXPECT_EQ(closed_where_nothing_is_seen({}).mesh.triangles.rows(), 0);
  PointCloud without_normals = ball(0.04);
  without_normals.normals.setZero();
  EXPECT_EQ(closed_where_nothing_is_seen({.observed = without_normals}).mesh.triangles.rows(), 0);
  const PointCloud whole = testing::box({0.1, 0.14, 0.08});
  for (const Index count : {1U, 2U, 5U, 30U}) {
    PointIndices few(count);
    for (Index i = 0; i < count; ++i) few[i] = i * 7U;
    const ObjectSurface surface = closed_where_nothing_is_seen({.observed = select(whole, few)});
    expect_watertight(surface.mesh);
    // A point or a line segment has no inside.
    EXPECT_EQ(surface.mesh.triangles.rows() != 0, count > 2) << count;
  }
  PointIndices top;
  for (Index i = 0; i < whole.size(); ++i) {
    if (whole.normals(i, 2) > 0.9F) top.push_back(i);
  }
  PointCloud sheet = select(whole, top);
  const ObjectSurface flat = closed_where_nothing_is_seen({.observed = sheet});
  expect_watertight(flat.mesh);
  EXPECT_GT(flat.mesh.triangles.rows(), 0);
  sheet.positions.col(2).setConstant(0.004F);  // 4 mm above the table
  const ObjectSurface slab = closed_where_nothing_is_seen({.observed = sheet, .table = Plane{}});
  expect_watertight(slab.mesh);
  EXPECT_NEAR(solid_properties(slab.mesh).volume / (0.1 * 0.14 * 0.004), 1.0, 0.1);
}

TEST(ObjectSurface, OfALargeObjectTakesNoMoreNodesThanAllowed) {
  ObjectSurfaceOptions options;
  options.max_nodes = 20000;
  const PointCloud whole = testing::box({0.3, 0.3, 0.3}), nothing;
  const DistanceField field = nothing_seen(whole, std::nullopt);
  const std::optional<Plane> no_table;
  const ObjectSurface surface =
      object_surface({whole, nothing, {}, {}}, {field, no_table}, options);
  expect_watertight(surface.mesh);
  EXPECT_LT(surface.mesh.vertices.rows(), 20000);
  EXPECT_NEAR(solid_properties(surface.mesh).volume / 0.027, 1.0, 0.12);  // of cells of 12 mm
  const auto observed = std::count(surface.observed.begin(), surface.observed.end(), 1);
  EXPECT_EQ(observed, surface.mesh.triangles.rows());
}

TEST(ObjectSurface, RefusesInvalidOptions) {
  ObjectSurfaceOptions options;
  options.voxel_size = 0.0;
  const PointCloud whole = testing::vase(), nothing;
  const DistanceField field = nothing_seen(whole, std::nullopt);
  const std::optional<Plane> no_table;
  EXPECT_THROW(object_surface({whole, nothing, {}, {}}, {field, no_table}, options), InputError);
  CompletionOptions completion;
  completion.square_tolerance = 2.0;
  EXPECT_THROW(object_surface({whole, nothing, {}, {}}, {field, no_table}, {}, completion),
               InputError);
}

}  // namespace
}  // namespace symscene
