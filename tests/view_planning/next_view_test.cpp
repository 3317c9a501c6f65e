#include "symscene/view_planning/next_view.hpp"

#include <gtest/gtest.h>

#include "core/looking_at.hpp"
#include "core/surface_sampling.hpp"
#include "simulation/shapes.hpp"
#include "symscene/core/error.hpp"
#include "symscene/view_planning/view_candidates.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

CameraIntrinsics camera() { return {160, 120, 150.0, 150.0, 79.5, 59.5}; }

/// Views level with the table from the four sides: +x, +y, −x and −y.
std::vector<Eigen::Isometry3d> four_sides() {
  std::vector<Eigen::Isometry3d> views;
  for (const Eigen::Vector3d& side :
       {Eigen::Vector3d(0.6, 0.0, 0.05), Eigen::Vector3d(0.0, 0.6, 0.05),
        Eigen::Vector3d(-0.6, 0.0, 0.05), Eigen::Vector3d(0.0, -0.6, 0.05)})
    views.push_back(looking_at(side, {0.0, 0.0, 0.05}, Eigen::Vector3d::UnitZ()));
  return views;
}

/// A box of 10 cm on the table z = 0 around (x, y), of which only the faces towards the given
/// directions were seen.
void add_box(SegmentationResult& result, double x, double y,
             std::initializer_list<Eigen::Vector3f> seen) {
  TriangleMesh mesh = make_box({0.1, 0.1, 0.1}, 0.01);
  mesh.vertices.rowwise() += Eigen::RowVector3f(static_cast<float>(x), static_cast<float>(y), 0.0F);
  ObjectSurface surface{mesh, {}};
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](int k) -> Eigen::Vector3f {
      return mesh.vertices.row(mesh.triangles(t, k)).transpose();
    };
    const Eigen::Vector3f normal =
        (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    bool is_seen = false;
    for (const Eigen::Vector3f& direction : seen) is_seen = is_seen || normal.dot(direction) > 0.9F;
    surface.observed.push_back(is_seen ? 1 : 0);
  }
  const PointCloud points = sample_surface(mesh, 500);
  SceneObject object;
  object.score = 0.9;
  for (Index i = 0; i < points.size(); ++i) object.points.push_back(result.cloud.size() + i);
  const Eigen::Index before = result.cloud.positions.rows(), more = points.positions.rows();
  result.cloud.positions.conservativeResize(before + more, 3);
  result.cloud.normals.conservativeResize(before + more, 3);
  result.cloud.positions.bottomRows(more) = points.positions;
  result.cloud.normals.bottomRows(more) = points.normals;
  result.objects.push_back(object);
  result.surfaces.push_back(surface);
  result.completed.emplace_back();
}

/// Space of which nothing was seen.
const OccupancyMap unseen;

std::size_t best(const SegmentationResult& result, const NextViewOptions& options = {}) {
  return rank_views({result, &unseen}, camera(), four_sides(), options).ranked.front().candidate;
}

TEST(RankViews, PrefersTheSideOfWhichNothingIsKnown) {
  for (int hidden = 0; hidden < 4; ++hidden) {
    std::vector<Eigen::Vector3f> sides{Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitY(),
                                       -Eigen::Vector3f::UnitX(), -Eigen::Vector3f::UnitY()};
    sides.erase(sides.begin() + hidden);
    SegmentationResult result;
    add_box(result, 0.0, 0.0, {sides[0], sides[1], sides[2]});
    EXPECT_EQ(best(result), static_cast<std::size_t>(hidden));
  }
}

TEST(RankViews, PrefersWhatNoSymmetryExplains) {
  SegmentationResult result;
  add_box(result, 0.0, 0.0, {-Eigen::Vector3f::UnitX(), -Eigen::Vector3f::UnitY()});
  // The face towards +x is the image of that towards −x.
  Points& images = result.completed[0].positions;
  for (int i = 0; i <= 20; ++i) {
    for (int j = 0; j <= 20; ++j) {
      images.conservativeResize(images.rows() + 1, 3);
      images.row(images.rows() - 1) << 0.05F, -0.05F + 0.005F * static_cast<float>(i),
          0.005F * static_cast<float>(j);
    }
  }
  result.completed[0].normals = Points::Zero(images.rows(), 3);
  EXPECT_EQ(best(result), 1U);
}

TEST(RankViews, DoesNotSeeThroughAnotherObject) {
  SegmentationResult result;
  add_box(result, 0.0, 0.0, {-Eigen::Vector3f::UnitX(), -Eigen::Vector3f::UnitY()});
  const std::size_t alone = best(result);
  // A second box, known all around, stands before the side that was best.
  const double x = alone == 0 ? 0.13 : 0.0, y = alone == 1 ? 0.13 : 0.0;
  add_box(result, x, y,
          {Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitY(), -Eigen::Vector3f::UnitX(),
           -Eigen::Vector3f::UnitY(), Eigen::Vector3f::UnitZ()});
  EXPECT_EQ(best(result), 1U - alone);
}

TEST(RankViews, IsEnoughWhereAllIsSeen) {
  SegmentationResult result;
  add_box(result, 0.0, 0.0, {-Eigen::Vector3f::UnitX()});
  EXPECT_FALSE(rank_views({result, &unseen}, camera(), four_sides()).is_enough);
  result.surfaces[0].observed.assign(result.surfaces[0].observed.size(), 1);
  const NextViews views = rank_views({result, &unseen}, camera(), four_sides());
  EXPECT_TRUE(views.is_enough);
  EXPECT_EQ(views.inferred_area, 0.0);
}

TEST(RankViews, TellsPerObjectWhatIsInferredOfItsSurface) {
  SegmentationResult result;
  add_box(result, 0.0, 0.0, {-Eigen::Vector3f::UnitX()});
  add_box(result, 0.3, 0.0, {});
  const NextViews views = rank_views({result, &unseen}, camera(), four_sides());
  ASSERT_EQ(views.areas.size(), 2U);
  // Sides of 10 cm; nothing is known to be a table, so that all six count.
  EXPECT_NEAR(views.areas[0].inferred, 0.05, 1e-4);
  EXPECT_NEAR(views.areas[0].all, 0.06, 1e-4);
  EXPECT_NEAR(views.areas[1].inferred, 0.06, 1e-4);
  EXPECT_DOUBLE_EQ(views.areas[0].inferred + views.areas[1].inferred, views.inferred_area);
  EXPECT_DOUBLE_EQ(views.areas[0].all + views.areas[1].all, views.object_area);
}

TEST(RankViews, WeighsCosts) {
  SegmentationResult result;
  add_box(result, 0.0, 0.0, {-Eigen::Vector3f::UnitX()});
  NextViewOptions options;
  options.cost_weight = 1.0;
  const std::array<double, 4> costs{1.0, 1.0, 0.0, 1.0};
  const NextViews views =
      rank_views({result, &unseen}, camera(), four_sides(), options, ViewPolicy::symmetry, costs);
  EXPECT_EQ(views.ranked.front().candidate, 2U);
  EXPECT_THROW(rank_views({result, &unseen}, camera(), four_sides(), options, ViewPolicy::symmetry,
                          std::array<double, 1>{0.0}),
               InputError);
}

/// Gains of a camera 0.5 m from a box that was seen from −x only, which looks at it along +x or −x.
double gain_from(const Eigen::Vector3d& eye, const std::optional<Plane>& table = {},
                 const NextViewOptions& options = {}) {
  SegmentationResult result;
  add_box(result, 0.0, 0.0, {-Eigen::Vector3f::UnitX()});
  result.table = table;
  const std::array<Eigen::Isometry3d, 1> pose{
      looking_at(eye, {0.0, 0.0, 0.05}, Eigen::Vector3d::UnitX())};
  return rank_views({result, &unseen}, camera(), pose, options).ranked.front().gain.total();
}

TEST(RankViews, SeesNothingFromBelowTheTable) {
  const Eigen::Vector3d below(0.0, 0.0, -0.5);
  EXPECT_GT(gain_from(below), 0.0) << "without a table";
  EXPECT_EQ(gain_from(below, Plane{Eigen::Vector3d::UnitZ(), 0.0}), 0.0);
}

TEST(RankViews, SeesOnlyWhatTheCameraMeasures) {
  const Eigen::Vector3d side(0.5, 0.0, 0.2);
  NextViewOptions options;
  EXPECT_GT(gain_from(side, {}, options), 0.0);
  options.min_depth = 0.8;
  EXPECT_EQ(gain_from(side, {}, options), 0.0);
  options.min_depth = 0.2;
  options.max_depth = 0.3;
  EXPECT_EQ(gain_from(side, {}, options), 0.0);
}

TEST(RankViews, WeighsDisputeByHowNearTheHypothesisCameToItsBound) {
  const auto disputed = [](double value, double bound) {
    SegmentationResult result;
    add_box(result, 0.0, 0.0,
            {Eigen::Vector3f::UnitX(), -Eigen::Vector3f::UnitX(), Eigen::Vector3f::UnitY(),
             -Eigen::Vector3f::UnitY(), Eigen::Vector3f::UnitZ()});
    Rejection rejected;
    rejected.value = value;
    rejected.bound = bound;
    const PointIndices& points = result.objects[0].points;
    rejected.points.assign(points.begin(), points.begin() + 250);
    result.rejected.push_back(rejected);
    return rank_views({result, &unseen}, camera(), four_sides()).ranked.front().gain.disputed;
  };
  EXPECT_GT(disputed(0.4, 0.45), 1.5 * disputed(0.2, 0.45)) << "a score that is too low";
  EXPECT_GT(disputed(0.02, 0.015), 1.5 * disputed(0.06, 0.015)) << "a residual that is too high";
}

TEST(RankViews, RefusesWhatIsFarAwayOrInconsistent) {
  SegmentationResult result;
  add_box(result, 0.0, 0.0, {-Eigen::Vector3f::UnitX()});
  std::vector<Eigen::Isometry3d> far = four_sides();
  far[2].translation().z() = 1e20;
  EXPECT_THROW(rank_views({result, &unseen}, camera(), far), InputError);
  result.surfaces.push_back(result.surfaces.front());
  EXPECT_THROW(rank_views({result, &unseen}, camera(), four_sides()), InputError);
}

TEST(RankViews, LeavesOutWhatCannotBeReached) {
  SegmentationResult result;
  add_box(result, 0.0, 0.0, {-Eigen::Vector3f::UnitX()});
  const std::array<double, 4> costs{0.0, std::numeric_limits<double>::infinity(), 0.0, 0.0};
  const NextViews views =
      rank_views({result, &unseen}, camera(), four_sides(), {}, ViewPolicy::symmetry, costs);
  EXPECT_EQ(views.ranked.size(), 3U);
  for (const RankedView& view : views.ranked) EXPECT_NE(view.candidate, 1U);
}

TEST(RankViews, GivesTheSameForAnyNumberOfThreads) {
  SegmentationResult result;
  add_box(result, 0.0, 0.0, {-Eigen::Vector3f::UnitX()});
  add_box(result, 0.15, 0.05, {-Eigen::Vector3f::UnitY()});
  const auto gains = [&] {
    std::vector<double> totals;
    for (const ViewPolicy policy :
         {ViewPolicy::symmetry, ViewPolicy::unknown_voxels, ViewPolicy::rear_side_voxels}) {
      for (const RankedView& view :
           rank_views({result, &unseen}, camera(), four_sides(), {}, policy).ranked)
        totals.push_back(view.gain.total());
    }
    return totals;
  };
  EXPECT_EQ(testing::with_threads(1, gains), testing::with_threads(3, gains));
}

TEST(RankViews, NeedNoOccupancyUnlessVoxelsAreCounted) {
  SegmentationResult result;
  add_box(result, 0.0, 0.0, {-Eigen::Vector3f::UnitX(), -Eigen::Vector3f::UnitY()});
  EXPECT_LT(rank_views({result}, camera(), four_sides()).ranked.front().candidate, 2U);
  EXPECT_THROW(rank_views({result}, camera(), four_sides(), {}, ViewPolicy::unknown_voxels),
               InputError);
}

TEST(RankViews, OfNothingAreNone) {
  const NextViews views = rank_views({SegmentationResult{}, &unseen}, camera(), four_sides());
  EXPECT_TRUE(views.ranked.empty());
  EXPECT_TRUE(views.is_enough) << "so that a loop ends";
}

}  // namespace
}  // namespace symscene
