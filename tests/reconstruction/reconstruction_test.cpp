#include "symscene/reconstruction/reconstruction.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "reconstruction/analytic_scenes.hpp"
#include "symscene/core/error.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

DepthFrame table_frame(double angle) {
  return render(tabletop(), small_camera(), around_table(angle));
}

DepthFrame black() { return flat_frame(small_camera(), 0.0F); }

double degrees_apart(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return degrees(Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle());
}

double apart(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.translation() - b.translation()).norm();
}

/// A reconstruction of a sweep around the table from 0 to 0.3 rad.
Reconstruction after_a_sweep() {
  Reconstruction reconstruction(small_camera());
  for (int k = 0; k <= 10; ++k) {
    const FrameReport report = reconstruction.add(table_frame(0.03 * k));
    EXPECT_TRUE(report.fused) << k << ": " << report.tracking.reason;
  }
  return reconstruction;
}

/// The pose of a camera at an angle in the world of a sweep that began at 0.
Eigen::Isometry3d in_sweep(double angle) {
  return around_table(0.0).inverse() * around_table(angle);
}

TEST(Reconstruction, FollowsACameraAroundATable) {
  Reconstruction reconstruction(small_camera());
  for (int k = 0; k <= 15; ++k) {
    const FrameReport report = reconstruction.add(table_frame(0.03 * k));
    ASSERT_EQ(report.tracking.status, TrackingStatus::converged) << report.tracking.reason;
    EXPECT_TRUE(report.fused);
    EXPECT_FALSE(report.relocalized);
    const Eigen::Isometry3d truth = in_sweep(0.03 * k);
    EXPECT_LT(apart(report.tracking.T_world_camera, truth), 0.003) << k;
    EXPECT_LT(degrees_apart(report.tracking.T_world_camera, truth), 0.3) << k;
  }
  EXPECT_GT(reconstruction.surface().vertices.rows(), 5000);
}

TEST(Reconstruction, BeginsAtTheOriginOrAtTheFirstFramesPose) {
  Reconstruction at_origin(small_camera());
  EXPECT_TRUE(at_origin.add(table_frame(0))
                  .tracking.T_world_camera.isApprox(Eigen::Isometry3d::Identity()));
  Reconstruction at_pose(small_camera());
  const FrameReport first = at_pose.add(table_frame(0), around_table(0), PoseUse::start);
  EXPECT_TRUE(first.tracking.T_world_camera.isApprox(around_table(0)));
  const FrameReport second = at_pose.add(table_frame(0.03));
  EXPECT_LT(apart(second.tracking.T_world_camera, around_table(0.03)), 0.001);
}

/// The number of pixels that show a vertex of the surface in the depth that they measure.
std::size_t pixels_with_a_vertex(const DepthFrame& frame, const TriangleMesh& surface) {
  const CameraIntrinsics camera = small_camera();
  std::vector<bool> shows(frame.depth.size(), false);
  for (Eigen::Index i = 0; i < surface.vertices.rows(); ++i) {
    const Eigen::Vector3d point = surface.vertices.row(i).cast<double>();
    const auto x = std::lround(camera.fx * point.x() / point.z() + camera.cx);
    const auto y = std::lround(camera.fy * point.y() / point.z() + camera.cy);
    if (x < 0 || y < 0 || x >= camera.width || y >= camera.height) continue;
    const auto pixel = static_cast<std::size_t>(y * camera.width + x);
    if (std::abs(point.z() - double{frame.depth[pixel]}) < 0.01) shows[pixel] = true;
  }
  return static_cast<std::size_t>(std::count(shows.begin(), shows.end(), true));
}

TEST(Reconstruction, OfOneFrameShowsThatFrame) {
  Reconstruction reconstruction(small_camera());
  const FrameReport report = reconstruction.add(table_frame(0));
  EXPECT_TRUE(report.fused);
  EXPECT_EQ(report.tracking.status, TrackingStatus::converged);
  EXPECT_GT(reconstruction.surface().vertices.rows(), 1000);
  EXPECT_FALSE(reconstruction.occupancy().map().leaves.empty());
  EXPECT_GT(pixels_with_a_vertex(table_frame(0), reconstruction.surface()),
            8 * table_frame(0).depth.size() / 10);
}

TEST(Reconstruction, WaitsForTheFirstFrameWithDepth) {
  Reconstruction reconstruction(small_camera());
  for (int k = 0; k < 3; ++k) {
    const FrameReport report = reconstruction.add(black());
    EXPECT_EQ(report.tracking.status, TrackingStatus::lost);
    EXPECT_STRNE(report.tracking.reason, "");
    EXPECT_FALSE(report.fused);
    EXPECT_TRUE(reconstruction.empty());
  }
  const FrameReport first = reconstruction.add(table_frame(0));
  EXPECT_TRUE(first.fused);
  EXPECT_FALSE(first.relocalized);
  EXPECT_TRUE(first.tracking.T_world_camera.isApprox(Eigen::Isometry3d::Identity()));
}

TEST(Reconstruction, SkipsABlackFrameAndContinuesAfterIt) {
  Reconstruction reconstruction = after_a_sweep();
  const std::size_t bytes = reconstruction.bytes();
  const LogOddsMap space = reconstruction.occupancy().log_odds();
  const FrameReport dark = reconstruction.add(black());
  EXPECT_EQ(dark.tracking.status, TrackingStatus::lost);
  EXPECT_FALSE(dark.fused);
  EXPECT_EQ(reconstruction.bytes(), bytes);
  EXPECT_EQ(reconstruction.occupancy().log_odds().leaves.size(), space.leaves.size());
  const FrameReport again = reconstruction.add(table_frame(0.31));
  EXPECT_TRUE(again.fused) << again.tracking.reason;
  EXPECT_TRUE(again.relocalized);
  EXPECT_LT(apart(again.tracking.T_world_camera, in_sweep(0.31)), 0.004);
}

TEST(Reconstruction, DoesNotFuseAnotherScene) {
  Reconstruction reconstruction = after_a_sweep();
  const TriangleMesh before = reconstruction.surface();
  const std::vector<Bodies> others{
      {plane(-Eigen::Vector3d::UnitZ(), 1.6)},
      {sphere({0, 0, 1.0}, 0.3)},
      {plane(Eigen::Vector3d(1, 0, -1).normalized(), 1.2), sphere({0.1, 0.1, 0.5}, 0.1)}};
  for (const Bodies& other : others) {
    for (int k = 0; k < 2; ++k) {
      const FrameReport report =
          reconstruction.add(render(other, small_camera(), Eigen::Isometry3d::Identity()));
      EXPECT_EQ(report.tracking.status, TrackingStatus::lost);
      EXPECT_FALSE(report.fused);
    }
  }
  EXPECT_TRUE(same(reconstruction.surface(), before));
}

TEST(Reconstruction, RelocalizesACameraThatComesBackElsewhere) {
  Reconstruction reconstruction(small_camera());
  for (int k = 0; k <= 16; ++k) {
    ASSERT_TRUE(reconstruction.add(table_frame(0.045 * k)).fused) << k;
  }
  const Bodies wall{plane(-Eigen::Vector3d::UnitZ(), 2.2)};
  for (int k = 0; k < 3; ++k) {
    EXPECT_FALSE(
        reconstruction.add(render(wall, small_camera(), Eigen::Isometry3d::Identity())).fused);
  }
  // Not where it was last, at 0.72 rad, but near where it began.
  const FrameReport back = reconstruction.add(table_frame(0.04));
  EXPECT_TRUE(back.relocalized);
  EXPECT_TRUE(back.fused) << back.tracking.reason << ", agreement " << back.tracking.agreement;
  EXPECT_LT(apart(back.tracking.T_world_camera, in_sweep(0.04)), 0.005);
  EXPECT_LT(degrees_apart(back.tracking.T_world_camera, in_sweep(0.04)), 0.5);
  const FrameReport next = reconstruction.add(table_frame(0.07));
  EXPECT_TRUE(next.fused);
  EXPECT_FALSE(next.relocalized);
  EXPECT_LT(apart(next.tracking.T_world_camera, in_sweep(0.07)), 0.005);
}

TEST(Reconstruction, DoesNotContinueAtAWrongPoseAfterAGap) {
  for (const double gap : {0.1, 0.25, 0.4}) {
    Reconstruction reconstruction(small_camera());
    for (int k = 0; k <= 8; ++k) {
      ASSERT_TRUE(reconstruction.add(table_frame(0.045 * k)).fused) << k;
    }
    const FrameReport after = reconstruction.add(table_frame(0.36 + gap));
    if (!after.fused) continue;
    EXPECT_LT(apart(after.tracking.T_world_camera, in_sweep(0.36 + gap)), 0.005) << gap;
    EXPECT_LT(degrees_apart(after.tracking.T_world_camera, in_sweep(0.36 + gap)), 0.5) << gap;
  }
}

TEST(Reconstruction, UsesExactPosesUnchanged) {
  Reconstruction reconstruction(small_camera());
  for (const double angle : {0.0, 1.0, 2.0, 3.0}) {
    const FrameReport report = reconstruction.add(table_frame(angle), around_table(angle));
    EXPECT_EQ(report.tracking.status, TrackingStatus::converged);
    EXPECT_TRUE(report.fused);
    EXPECT_EQ(report.tracking.T_world_camera.matrix(), around_table(angle).matrix());
  }
  const TriangleMesh mesh = reconstruction.surface();
  std::size_t on_table = 0;
  for (Eigen::Index i = 0; i < mesh.vertices.rows(); ++i) {
    on_table += std::abs(mesh.vertices(i, 2)) < 0.003F ? 1 : 0;
    EXPECT_GT(mesh.vertices(i, 2), -0.005F);
  }
  EXPECT_GT(on_table, 3000U);
}

TEST(Reconstruction, CorrectsPosesThatTrackingStartsFrom) {
  Reconstruction reconstruction(small_camera());
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.004);
  for (int k = 0; k <= 8; ++k) {
    const Eigen::Isometry3d truth = around_table(0.05 * k);
    const Eigen::Vector3d turn(noise(random), noise(random), noise(random));
    const Eigen::Vector3d shift(noise(random), noise(random), noise(random));
    const Eigen::Isometry3d rough = k == 0 ? truth : truth * motion(turn, shift);
    const FrameReport report = reconstruction.add(table_frame(0.05 * k), rough, PoseUse::start);
    ASSERT_TRUE(report.fused) << report.tracking.reason;
    EXPECT_LT(apart(report.tracking.T_world_camera, truth), 0.003);
  }
}

TEST(Reconstruction, RefusesInvalidFramesAndPosesWithoutChange) {
  Reconstruction reconstruction = after_a_sweep();
  const TriangleMesh before = reconstruction.surface();
  DepthFrame small = table_frame(0.3);
  small.depth.resize(100);
  EXPECT_THROW(reconstruction.add(small), InputError);
  EXPECT_THROW(reconstruction.add({}), InputError);
  const auto refused = [&](auto&& change) {
    Eigen::Isometry3d pose = in_sweep(0.3);
    change(pose);
    EXPECT_THROW(reconstruction.add(table_frame(0.3), pose), InputError);
    EXPECT_THROW(reconstruction.add(table_frame(0.3), pose, PoseUse::start), InputError);
  };
  refused([](auto& T) { T.translation().x() = std::numeric_limits<double>::quiet_NaN(); });
  refused([](auto& T) { T.translation().z() = std::numeric_limits<double>::infinity(); });
  refused([](auto& T) { T.translation().y() = 1e6; });
  refused([](auto& T) { T.linear() *= 2.0; });
  refused([](auto& T) { T.linear().col(0) *= -1.0; });
  EXPECT_TRUE(same(reconstruction.surface(), before));
  EXPECT_TRUE(reconstruction.add(table_frame(0.31)).fused);
}

TEST(Reconstruction, SurvivesACameraBeyondItsReach) {
  Reconstruction reconstruction(small_camera());
  const Eigen::Isometry3d far = motion({0, 0, 0}, {9e4, 0, 0});
  EXPECT_NO_THROW(reconstruction.add(table_frame(0), far));
  EXPECT_TRUE(reconstruction.empty());
  EXPECT_TRUE(reconstruction.surface().vertices.rows() == 0);
  EXPECT_TRUE(reconstruction.add(table_frame(0), around_table(0)).fused);
  EXPECT_GT(reconstruction.surface().vertices.rows(), 1000);
}

TEST(Reconstruction, TakesNoMoreMemoryWhenFramesRepeat) {
  const CameraIntrinsics camera{80, 60, 70.0, 70.0, 39.5, 29.5};
  const DepthFrame frame = render(tabletop(), camera, around_table(0));
  Reconstruction reconstruction(camera);
  for (int k = 0; k < 5; ++k) reconstruction.add(frame);
  const std::size_t before = reconstruction.bytes(), space = reconstruction.occupancy().memory();
  Eigen::Isometry3d last;
  for (int k = 0; k < 60; ++k) last = reconstruction.add(frame).tracking.T_world_camera;
  EXPECT_LE(reconstruction.bytes(), before + before / 10);
  EXPECT_LE(reconstruction.occupancy().memory(), space + space / 5);
  EXPECT_LT(apart(last, Eigen::Isometry3d::Identity()), 0.005) << "a camera that stands drifts";
}

TEST(Reconstruction, ReportsTimes) {
  Reconstruction reconstruction(small_camera());
  reconstruction.add(table_frame(0));
  EXPECT_EQ(reconstruction.times().size(), 5U);
  for (const StageTime& time : reconstruction.times()) EXPECT_GE(time.seconds, 0.0);
  EXPECT_GT(reconstruction.times()[0].seconds, 0.0);
}

TEST(Reconstruction, IsTheSameForAnyNumberOfThreads) {
  struct Outcome {
    TriangleMesh mesh;
    std::vector<Eigen::Isometry3d> poses;
    std::vector<LogOddsLeaf> space;
  };
  const auto run = [] {
    Outcome outcome;
    Reconstruction reconstruction(small_camera());
    for (const double angle : {0.0, 0.04, 0.08, 2.0, 0.02, 0.06}) {
      DepthFrame frame = angle == 2.0 ? black() : table_frame(angle);
      paint(frame, 90, 80, 70);
      outcome.poses.push_back(reconstruction.add(frame).tracking.T_world_camera);
    }
    outcome.mesh = reconstruction.surface();
    outcome.space = reconstruction.occupancy().log_odds().leaves;
    return outcome;
  };
  const Outcome one = with_threads(1, run);
  for (const std::size_t threads : {2U, 4U}) {
    const Outcome more = with_threads(threads, run);
    for (std::size_t k = 0; k < one.poses.size(); ++k) {
      EXPECT_EQ(more.poses[k].matrix(), one.poses[k].matrix());
    }
    EXPECT_TRUE(same(more.mesh, one.mesh));
    EXPECT_TRUE(std::equal(one.space.begin(), one.space.end(), more.space.begin(), more.space.end(),
                           [](const LogOddsLeaf& a, const LogOddsLeaf& b) {
                             return a.key == b.key && a.level == b.level &&
                                    a.log_odds == b.log_odds;
                           }));
  }
}

}  // namespace
}  // namespace symscene
