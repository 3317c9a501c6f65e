#include "symscene/simulation/truth_transfer.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/surface_sampling.hpp"
#include "simulation/shapes.hpp"
#include "simulation/true_surface.hpp"
#include "symscene/core/error.hpp"
#include "symscene/simulation/sweep.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

Eigen::Isometry3d some_motion() {
  Eigen::Isometry3d motion(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()));
  motion.pretranslate(Eigen::Vector3d(0.3, -0.5, 1.1));
  return motion;
}

PlacedObject box_at(const char* name, double x) {
  ObjectModel model{name, make_box({0.1, 0.1, 0.1}, 0.02), {}, {}, false};
  model.reflectional.push_back({{{0, 0, 0}, {1, 0, 0}}, true});
  return {model, Eigen::Isometry3d(Eigen::Translation3d(x, 0, 0)), PlacedObject::on_table};
}

/// Two boxes side by side and a small one that nothing sees.
Tabletop three_boxes() {
  Tabletop tabletop;
  tabletop.objects = {box_at("left", -0.1), box_at("right", 0.1), box_at("hidden", 0.5)};
  return tabletop;
}

std::vector<TriangleMesh> meshes_of(const Tabletop& tabletop) {
  std::vector<TriangleMesh> meshes;
  for (const PlacedObject& placed : tabletop.objects) meshes.push_back(placed.object.mesh);
  return meshes;
}

/// 2,000 points on each of the first two boxes, then some on the table and some in the air.
PointCloud seen_cloud(const Tabletop& tabletop, const Eigen::Isometry3d& T_cloud_truth) {
  std::vector<Eigen::Vector3f> points;
  for (int k = 0; k < 2; ++k) {
    const Points own =
        sample_surface(world_mesh(tabletop.objects[static_cast<std::size_t>(k)]), 2000).positions;
    for (Eigen::Index i = 0; i < own.rows(); ++i) points.push_back(own.row(i).transpose());
  }
  for (int i = 0; i < 50; ++i) {
    points.emplace_back(0.01F * static_cast<float>(i), 0.3F, 0.001F);
    points.emplace_back(0.01F * static_cast<float>(i), 0.0F, 0.4F);
  }
  PointCloud cloud;
  cloud.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    cloud.positions.row(static_cast<Eigen::Index>(i)) =
        (T_cloud_truth.cast<float>() * points[i]).transpose();
  }
  return cloud;
}

TEST(TransferTruth, GivesEachPointTheObjectThatItShows) {
  const Tabletop tabletop = three_boxes();
  const Eigen::Isometry3d T = some_motion();
  const PointCloud cloud = seen_cloud(tabletop, T);
  const SceneTruth truth = transfer_truth(tabletop_truth(tabletop), meshes_of(tabletop), cloud, T);
  ASSERT_EQ(truth.objects.size(), 2U) << "what shows too few points is left out";
  EXPECT_EQ(truth.objects[0].name, "left");
  EXPECT_EQ(truth.objects[1].name, "right");
  const Index half = (cloud.size() - 100) / 2;
  for (std::size_t k = 0; k < 2; ++k) {
    const PointIndices& mask = truth.objects[k].points;
    // Points at the boxes' feet are the table's as much.
    EXPECT_GT(mask.size(), half * 3 / 4);
    EXPECT_GE(mask.front(), k * half);
    EXPECT_LT(mask.back(), (k + 1) * half);
  }
}

TEST(TransferTruth, MovesTheGroundTruthIntoTheFrameOfTheCloud) {
  const Tabletop tabletop = three_boxes();
  const Eigen::Isometry3d T = some_motion();
  const SceneTruth before = tabletop_truth(tabletop);
  const SceneTruth after = transfer_truth(before, meshes_of(tabletop), seen_cloud(tabletop, T), T);
  const Eigen::Vector3d p(0.2, -0.1, 0.3);
  EXPECT_NEAR(after.table.signed_distance(T * p), before.table.signed_distance(p), 1e-12);
  const TrueObject& object = after.objects[1];
  EXPECT_TRUE(object.centroid.isApprox(T * before.objects[1].centroid, 1e-12));
  EXPECT_TRUE(object.T_world_mesh->isApprox(T * tabletop.objects[1].T_world_object, 1e-12));
  const ReflectionPlane& plane = object.reflectional.at(0).plane;
  EXPECT_TRUE(plane.reflect_point(T * p).isApprox(
      T * before.objects[1].reflectional.at(0).plane.reflect_point(p), 1e-12));
}

constexpr Index seen_pixels = 30 * 20;

/// An image of 30 by 20 pixels whose left half shows the first object, 5 cm farther than it is.
SensorFrame half_an_image(const Tabletop& tabletop) {
  SensorFrame frame;
  frame.T_world_camera = some_motion();
  for (Index pixel = 0; pixel < seen_pixels; ++pixel) {
    frame.objects.push_back(pixel % 30 < 15 ? 0 : static_cast<Index>(tabletop.objects.size()));
    frame.depth.push_back(1.05F);
  }
  return frame;
}

PointCloud points_of(const SensorFrame& frame, const CameraIntrinsics& camera) {
  PointCloud cloud;
  cloud.positions.resize(seen_pixels, 3);
  for (Index pixel = 0; pixel < seen_pixels; ++pixel)
    cloud.positions.row(pixel) =
        (double{frame.depth[pixel]} * camera.ray(pixel % 30, pixel / 30)).cast<float>().transpose();
  return cloud;
}

TEST(ViewTruth, GivesEachPointTheObjectOfItsPixelWhereverTheErrorOfTheSensorMovesIt) {
  const Tabletop tabletop = three_boxes();
  const CameraIntrinsics camera{30, 20, 100.0, 100.0, 14.5, 9.5};
  const SensorFrame frame = half_an_image(tabletop);
  const SceneTruth before = tabletop_truth(tabletop);
  const SceneTruth truth = view_truth(before, frame, camera, points_of(frame, camera));
  ASSERT_EQ(truth.objects.size(), 1U);
  EXPECT_EQ(truth.objects[0].name, "left");
  ASSERT_EQ(truth.objects[0].points.size(), seen_pixels / 2);
  for (const Index point : truth.objects[0].points) EXPECT_LT(point % 30, 15U);
  EXPECT_TRUE(truth.objects[0].centroid.isApprox(
      some_motion().inverse() * before.objects[0].centroid, 1e-12));
}

TEST(ViewTruth, GivesPointsThatBridgeAHoleTheObjectAtItsBorder) {
  const Tabletop tabletop = three_boxes();
  const CameraIntrinsics camera{30, 20, 100.0, 100.0, 14.5, 9.5};
  SensorFrame frame = half_an_image(tabletop);
  const PointCloud cloud = points_of(frame, camera);
  for (Index pixel = 2; pixel < seen_pixels; pixel += 3) {
    frame.objects[pixel] = SensorFrame::nothing;
    frame.depth[pixel] = 0.0F;
  }
  const SceneTruth truth = view_truth(tabletop_truth(tabletop), frame, camera, cloud);
  ASSERT_EQ(truth.objects.size(), 1U);
  EXPECT_GE(truth.objects[0].points.size(), seen_pixels / 2);
  for (const Index point : truth.objects[0].points) EXPECT_LT(point % 30, 16U);
}

TEST(ViewTruth, RefusesAnImageOfAnotherSize) {
  const Tabletop tabletop = three_boxes();
  const SensorFrame frame = half_an_image(tabletop);
  EXPECT_THROW(view_truth(tabletop_truth(tabletop), frame, {31, 20, 100.0, 100.0, 14.5, 9.5}, {}),
               InputError);
}

/// A view whose left half shows the first object, in the frame of its camera.
LabelledView labelled(const SensorFrame& frame) {
  return {Eigen::Isometry3d::Identity(), frame.depth, frame.objects};
}

TEST(SweepTruth, GivesEachPointTheObjectThatMostViewsOfItShow) {
  const Tabletop tabletop = three_boxes();
  const CameraIntrinsics camera{30, 20, 100.0, 100.0, 14.5, 9.5};
  const SensorFrame frame = half_an_image(tabletop);
  LabelledView mistaken = labelled(frame);
  for (Index& object : mistaken.objects) object = 2;
  LabelledView nearer = mistaken;  // something before the points, so that it does not measure them
  for (float& z : nearer.depth) z = 0.9F;
  const LabelledSweep sweep{camera, {labelled(frame), labelled(frame), mistaken, nearer, nearer}};
  const SceneTruth before = tabletop_truth(tabletop);
  const SceneTruth truth = sweep_truth(before, sweep, points_of(frame, camera), some_motion());
  ASSERT_EQ(truth.objects.size(), 1U);
  EXPECT_EQ(truth.objects[0].name, "left");
  ASSERT_EQ(truth.objects[0].points.size(), seen_pixels / 2);
  for (const Index point : truth.objects[0].points) EXPECT_LT(point % 30, 15U);
  EXPECT_TRUE(
      truth.objects[0].centroid.isApprox(some_motion() * before.objects[0].centroid, 1e-12));
}

TEST(SweepTruth, GivesPointsThatNoViewMeasuredNoObject) {
  const Tabletop tabletop = three_boxes();
  const CameraIntrinsics camera{30, 20, 100.0, 100.0, 14.5, 9.5};
  const SensorFrame frame = half_an_image(tabletop);
  LabelledView behind = labelled(frame);
  behind.T_camera_cloud.linear() = Eigen::AngleAxisd(3.0, Eigen::Vector3d::UnitX()).matrix();
  const PointCloud cloud = points_of(frame, camera);
  EXPECT_TRUE(
      sweep_truth(tabletop_truth(tabletop), {camera, {}}, cloud, some_motion()).objects.empty());
  const LabelledSweep sweep{camera, {behind}};
  EXPECT_TRUE(sweep_truth(tabletop_truth(tabletop), sweep, cloud, some_motion()).objects.empty());
}

TEST(TransferTruth, RefusesGroundTruthWithoutMeshesOrPoses) {
  const Tabletop tabletop = three_boxes();
  SceneTruth truth = tabletop_truth(tabletop);
  const PointCloud cloud;
  EXPECT_THROW(transfer_truth(truth, {}, cloud, Eigen::Isometry3d::Identity()), InputError);
  truth.objects[1].T_world_mesh.reset();
  EXPECT_THROW(transfer_truth(truth, meshes_of(tabletop), cloud, Eigen::Isometry3d::Identity()),
               InputError);
}

TEST(AlignPoses, FindsTheMotionBetweenTwoFramesOfAPath) {
  const std::vector<Eigen::Isometry3d> path = camera_arc({});
  std::vector<Eigen::Isometry3d> moved;
  for (const Eigen::Isometry3d& pose : path) moved.push_back(some_motion() * pose);
  EXPECT_TRUE(align_poses(moved, path).isApprox(some_motion(), 1e-9));
  const std::span<const Eigen::Isometry3d> still(path.data(), 1);
  EXPECT_TRUE(align_poses(std::span(moved).first(1), still).isApprox(some_motion(), 1e-9));
  EXPECT_THROW(align_poses(moved, still), InputError);
}

TEST(TrueSurface, FindsTheNearestPointAsBruteForceDoes) {
  std::vector<TriangleMesh> meshes;
  for (const PlacedObject& placed : three_boxes().objects) meshes.push_back(world_mesh(placed));
  const TrueSurface surface(meshes);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-0.3, 0.7);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d p(at(random), at(random), at(random));
    Index nearest = 0;
    double least = 1e9;
    for (Index k = 0; k < meshes.size(); ++k) {
      const double x = k == 0 ? -0.1 : k == 1 ? 0.1 : 0.5;
      const Eigen::Vector3d q = p - Eigen::Vector3d(x, 0, 0.05);
      const Eigen::Vector3d out = q.cwiseAbs() - Eigen::Vector3d::Constant(0.05);
      const double distance = std::abs(out.cwiseMax(0.0).norm() + std::min(0.0, out.maxCoeff()));
      if (distance < least) std::tie(nearest, least) = std::pair(k, distance);
    }
    const TrueSurface::Nearest found = surface.nearest(p, 2.0);
    EXPECT_NEAR(found.distance, least, 1e-6);
    EXPECT_EQ(found.mesh, nearest);
  }
}

TEST(TrueSurface, FindsNothingBeyondTheRadius) {
  const std::vector<TriangleMesh> meshes = {make_box({0.1, 0.1, 0.1}, 0.1)};
  const TrueSurface surface(meshes);
  EXPECT_EQ(surface.nearest({0, 0, 0.2}, 0.09).mesh, TrueSurface::Nearest::nothing);
  EXPECT_EQ(surface.nearest({0, 0, 0.2}, 0.11).mesh, 0U);
}

TEST(SurfaceErrors, AreTheDistancesToTheMeshesOrTheTable) {
  const std::vector<TriangleMesh> meshes = {make_box({0.1, 0.1, 0.1}, 0.1)};
  Points points(4, 3);
  points << 0, 0, 0.103F,  // above the box
      0.5F, 0, 0.002F,     // above the table
      0, 0, 0.3F,          // beyond reach
      0.049F, 0, 0.05F;    // inside
  const SurfaceErrors errors = surface_errors(points, meshes, Plane{});
  EXPECT_NEAR(errors.distances[0], 0.003, 1e-6);
  EXPECT_NEAR(errors.distances[1], 0.002, 1e-6);
  EXPECT_NEAR(errors.distances[2], 0.05, 1e-6);
  EXPECT_NEAR(errors.distances[3], 0.001, 1e-6);
  EXPECT_EQ(errors.within_reach, 0.75);
  EXPECT_NEAR(errors.median, 0.002, 1e-6);
  EXPECT_EQ(surface_errors(Points(0, 3), meshes, Plane{}).median, 0.0);
}

TEST(TransferTruth, GivesTheSameMasksForAnyNumberOfThreads) {
  const Tabletop tabletop = three_boxes();
  const PointCloud cloud = seen_cloud(tabletop, some_motion());
  const auto run = [&] {
    return transfer_truth(tabletop_truth(tabletop), meshes_of(tabletop), cloud, some_motion());
  };
  const SceneTruth one = testing::with_threads(1, run);
  const SceneTruth two = testing::with_threads(2, run);
  ASSERT_EQ(one.objects.size(), two.objects.size());
  for (std::size_t k = 0; k < one.objects.size(); ++k)
    EXPECT_EQ(one.objects[k].points, two.objects[k].points);
}

}  // namespace
}  // namespace symscene
