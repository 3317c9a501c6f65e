#include "stitching/view_alignment.hpp"

#include <gtest/gtest.h>

#include "stitching/textured_scene.hpp"
#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace testing;

/// All poses but the first, moved by up to 2 cm and turned by up to 1.5°.
std::vector<Eigen::Isometry3d> perturbed(std::vector<Eigen::Isometry3d> poses, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const Eigen::Vector3d axis(random.normal(), random.normal(), random.normal());
    const Eigen::Vector3d way(random.normal(), random.normal(), random.normal());
    poses[i].linear() =
        Eigen::AngleAxisd(radians(random.uniform(0.5, 1.5)), axis.normalized()) * poses[i].linear();
    poses[i].translation() += random.uniform(0.005, 0.02) * way.normalized();
  }
  return poses;
}

std::vector<Measurement> measured(const Photographs& photographs) {
  std::vector<Measurement> views;
  for (const DepthFrame& frame : photographs.frames) {
    views.push_back(prepare_measurement(frame, camera, {}));
  }
  return views;
}

TEST(ViewAlignment, CorrectsPerturbedPoses) {
  const Photographs photographs = photograph_table({0, 30, 60, 90}, Look::plain);
  const std::vector<Measurement> views = measured(photographs);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto start = perturbed(photographs.truth, seed);
    const ViewAlignment aligned = align_views(views, start, {}, {}, {});
    EXPECT_TRUE(aligned.T_world_camera.front().isApprox(start.front()));
    for (std::size_t i = 1; i < views.size(); ++i) {
      const PoseError error = pose_error(aligned.T_world_camera[i], photographs.truth[i]);
      EXPECT_LT(error.distance, 0.003) << "view " << i << ", seed " << seed;
      EXPECT_LT(degrees(error.angle), 0.25) << "view " << i << ", seed " << seed;
      EXPECT_LT(aligned.fits[i].residual, 0.003);
      EXPECT_GT(aligned.fits[i].inliers, 0.8);
    }
  }
}

TEST(ViewAlignment, IsEquivariantUnderRigidMotion) {
  const Photographs photographs = photograph_table({0, 25, 50}, Look::plain);
  const std::vector<Measurement> views = measured(photographs);
  const auto start = perturbed(photographs.truth, 4);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  motion.translation() << 0.3, -0.2, 0.5;
  std::vector<Eigen::Isometry3d> moved;
  for (const auto& pose : start) moved.push_back(motion * pose);
  const ViewAlignment here = align_views(views, start, {}, {}, {});
  const ViewAlignment there = align_views(views, moved, {}, {}, {});
  for (std::size_t i = 0; i < views.size(); ++i) {
    const PoseError error = pose_error(there.T_world_camera[i], motion * here.T_world_camera[i]);
    EXPECT_LT(error.distance, 1e-3);
    EXPECT_LT(degrees(error.angle), 0.1);
  }
}

TEST(ViewAlignment, ConstrainsByPointsTheMotionsThatSurfacesLeaveFree) {
  const DepthFrame wall{0.0, std::vector<float>(camera.pixels(), 1.0F), {}};
  const std::vector<Measurement> views{prepare_measurement(wall, camera, {}),
                                       prepare_measurement(wall, camera, {})};
  std::vector<Eigen::Isometry3d> start(2, Eigen::Isometry3d::Identity());
  start[1].translation() << 0.03, -0.02, 0.01;
  PointPairs pairs{0, 1, Eigen::Matrix3Xd(3, 4), {}};
  pairs.points_first << -0.2, 0.2, 0.2, -0.2, -0.1, -0.1, 0.1, 0.1, 1, 1, 1, 1;
  pairs.points_second = pairs.points_first;
  const std::vector<PointPairs> points{pairs};
  const ViewAlignment aligned = align_views(views, start, points, {}, {});
  EXPECT_TRUE(aligned.converged);
  const PoseError error = pose_error(aligned.T_world_camera[1], Eigen::Isometry3d::Identity());
  EXPECT_LT(error.distance, 1e-3);
  EXPECT_LT(degrees(error.angle), 0.05);
}

TEST(ViewAlignment, KeepsThePosesOfViewsWithoutCommonSurface) {
  const DepthFrame nothing{0.0, std::vector<float>(camera.pixels(), 0.0F), {}};
  const std::vector<Measurement> views(2, prepare_measurement(nothing, camera, {}));
  const std::vector<Eigen::Isometry3d> start{Eigen::Isometry3d::Identity(), view_from(1.0)};
  const ViewAlignment aligned = align_views(views, start, {}, {}, {});
  EXPECT_TRUE(aligned.T_world_camera[1].isApprox(start[1]));
  EXPECT_EQ(aligned.fits[1].matches, 0U);
}

TEST(ViewAlignment, GivesTheSameBitsForAnyNumberOfThreads) {
  const Photographs photographs = photograph_table({0, 30, 60}, Look::plain);
  const std::vector<Measurement> views = measured(photographs);
  const auto start = perturbed(photographs.truth, 5);
  const auto with = [&](std::size_t threads) {
    return with_threads(threads, [&] { return align_views(views, start, {}, {}, {}); });
  };
  const ViewAlignment one = with(1), four = with(4);
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(one.T_world_camera[i].matrix(), four.T_world_camera[i].matrix());
    EXPECT_EQ(one.fits[i].residual, four.fits[i].residual);
  }
}

TEST(ViewAlignment, RefusesInconsistentInput) {
  const std::vector<Eigen::Isometry3d> poses(3, Eigen::Isometry3d::Identity());
  EXPECT_THROW(align_views({}, poses, {}, {}, {}), InputError);
  ViewAlignmentOptions options;
  options.iterations_fine = 0;
  EXPECT_THROW(align_views({}, {}, {}, options, {}), InputError);
}

}  // namespace
}  // namespace symscene
