// From points to reflection planes by the curves along the edges of a surface (section 3.4).
#include <gtest/gtest.h>

#include "segmentation/workspace.hpp"
#include "surfaces.hpp"
#include "symscene/segmentation/supervoxels.hpp"
#include "symscene/symmetry/curve_detection.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using testing::all_seen;
using testing::moved;
using testing::nothing_known;

const Eigen::Vector3d carton_size(0.1, 0.16, 0.22);

std::vector<EdgeCurve> curves_of(const PointCloud& cloud) {
  const NeighborLists neighbors = voxel_neighbors(cloud.positions, 0.005);
  return edge_curves(cloud, neighbors, facets(cloud, neighbors).labels);
}

std::vector<ReflectionalCandidate> planes_of(const PointCloud& cloud, const DistanceField& field) {
  return detect_reflectional_by_curves(cloud, curves_of(cloud), field).candidates;
}

/// Whether a plane of `candidates` is `truth`, measured at `here`.
bool is_found(const std::vector<ReflectionalCandidate>& candidates, const ReflectionPlane& truth,
              const Eigen::Vector3d& here) {
  const SameSymmetry same{here, radians(2.5), 0.004};
  return std::any_of(candidates.begin(), candidates.end(),
                     [&](const ReflectionalCandidate& c) { return same(c.plane, truth); });
}

/// The mirror planes of the box that is `motion` from where it stands about the z axis.
ReflectionPlane box_plane(const Eigen::Isometry3d& motion, int axis) {
  return {motion * Eigen::Vector3d(0.0, 0.0, carton_size.z() / 2.0),
          motion.linear() * Eigen::Vector3d::Unit(axis)};
}

TEST(PlanesOfCurves, AreTheMirrorPlanesOfABoxAndMoveWithIt) {
  const PointCloud box = testing::box(carton_size);
  for (const std::uint32_t seed : testing::seeds) {
    std::mt19937 generator(seed);
    const Eigen::Isometry3d motion = testing::random_motion(generator);
    const PointCloud cloud = moved(box, motion);
    const std::vector<ReflectionalCandidate> planes = planes_of(cloud, all_seen(cloud));
    for (int axis = 0; axis < 3; ++axis) {
      const ReflectionPlane truth = box_plane(motion, axis);
      EXPECT_TRUE(is_found(planes, truth, truth.point)) << "seed " << seed << " axis " << axis;
    }
  }
}

TEST(PlanesOfCurves, OfABoxOfWhichOneFaceIsSeenComeFromItsOutline) {
  const PointCloud face = testing::seen_from(testing::box(carton_size), {0.0F, 0.0F, 2.0F});
  ASSERT_GT(face.positions.col(2).minCoeff(), 0.2F);
  const std::vector<ReflectionalCandidate> planes = planes_of(face, nothing_known(face));
  const Eigen::Vector3d here = centroid(face.positions);
  for (const int axis : {0, 1})
    EXPECT_TRUE(is_found(planes, {here, Eigen::Vector3d::Unit(axis)}, here)) << "axis " << axis;
}

TEST(PlanesOfCurves, OfABoxOfWhichThreeFacesAreSeenAreItsMirrorPlanes) {
  const PointCloud seen = testing::seen_from(testing::box(carton_size), {1.0F, 0.8F, 1.0F});
  const std::vector<ReflectionalCandidate> planes = planes_of(seen, nothing_known(seen));
  for (int axis = 0; axis < 3; ++axis) {
    const ReflectionPlane truth = box_plane(Eigen::Isometry3d::Identity(), axis);
    EXPECT_TRUE(is_found(planes, truth, truth.point)) << "axis " << axis;
  }
}

TEST(PlanesOfCurves, OfTheRimsOfAVaseContainItsAxisOrMirrorItsEnds) {
  const PointCloud vase = testing::vase();
  const std::vector<ReflectionalCandidate> planes = planes_of(vase, nothing_known(vase));
  ASSERT_FALSE(planes.empty());
  const Eigen::Vector3d middle(0.0, 0.0, 0.1);
  const auto contains_axis = [&](const ReflectionalCandidate& candidate) {
    const SymmetryDifference apart = difference(candidate.plane, RotationAxis{}, middle);
    return apart.angle < radians(5.0) && apart.distance < 0.01;
  };
  EXPECT_TRUE(contains_axis(planes.front()));
  // The rims of its ends are circles, which a plane between them maps nearly onto each other.
  const ReflectionPlane between{middle, Eigen::Vector3d::UnitZ()};
  for (const ReflectionalCandidate& candidate : planes)
    EXPECT_TRUE(contains_axis(candidate) || is_found({candidate}, between, middle));
}

TEST(PlanesOfCurves, RefuseThoseThatReflectCurvesIntoFreeSpace) {
  // The mirror planes reflect the three faces that are seen onto those that are not.
  const PointCloud seen = testing::seen_from(testing::box(carton_size), {1.0F, 0.8F, 1.0F});
  const std::size_t unknown = planes_of(seen, nothing_known(seen)).size();
  EXPECT_LT(planes_of(seen, all_seen(seen)).size(), unknown);
}

TEST(PlanesOfCurves, AreTheSameForAnyNumberOfThreads) {
  const PointCloud cloud = testing::box(carton_size);
  const DistanceField field = nothing_known(cloud);
  std::vector<std::vector<ReflectionalCandidate>> found;
  for (const std::size_t threads : {1U, 8U})
    testing::with_threads(threads, [&] { found.push_back(planes_of(cloud, field)); });
  ASSERT_FALSE(found[0].empty());
  ASSERT_EQ(found[0].size(), found[1].size());
  for (std::size_t k = 0; k < found[0].size(); ++k) {
    EXPECT_EQ(found[0][k].plane.normal, found[1][k].plane.normal);
    EXPECT_EQ(found[0][k].plane.point, found[1][k].plane.point);
    EXPECT_EQ(found[0][k].support, found[1][k].support);
  }
}

TEST(PlanesOfCurves, OfABallAreNone) {
  // Its surface bends nowhere abruptly and has no rim.
  std::vector<ProfilePoint> profile;
  for (int k = 0; k <= 40; ++k) {
    const double angle = std::numbers::pi * k / 40.0;
    profile.push_back({0.06 * std::sin(angle), 0.06 * (1.0 - std::cos(angle))});
  }
  const PointCloud ball = testing::as_cloud(make_revolution(profile, 96, 0.005));
  EXPECT_TRUE(curves_of(ball).empty());
  EXPECT_TRUE(planes_of(ball, nothing_known(ball)).empty());
}

TEST(PlanesOfCurves, OfNothingAreNone) {
  const PointCloud cloud = testing::box(carton_size);
  EXPECT_TRUE(detect_reflectional_by_curves(cloud, {}, nothing_known(cloud)).candidates.empty());
  EXPECT_TRUE(curves_of(PointCloud{}).empty());
}

}  // namespace
}  // namespace symscene
