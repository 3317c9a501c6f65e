#include "reconstruction/camera_tracking.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reconstruction/analytic_scenes.hpp"
#include "threads.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

Measurement measure(const Bodies& bodies, const Eigen::Isometry3d& pose) {
  return prepare_measurement(render(bodies, small_camera(), pose), small_camera(), {});
}

/// An exact image as the view of a model, placed at `T_world_view`.
ModelView exact_view(const Bodies& bodies, const Eigen::Isometry3d& pose,
                     const Eigen::Isometry3d& T_world_view) {
  const DepthFrame frame = render(bodies, small_camera(), pose);
  return {find_surface(frame.depth, small_camera(), {}), T_world_view};
}

TrackingResult track(const Bodies& bodies, const Eigen::Isometry3d& from,
                     const Eigen::Isometry3d& to) {
  return track_camera(measure(bodies, to), exact_view(bodies, from, from), from, {}, {});
}

void expect_pose(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth,
                 double translation = 1e-3, double rotation = radians(0.05)) {
  const Eigen::Isometry3d error = truth.inverse() * found;
  EXPECT_LT(error.translation().norm(), translation);
  EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), rotation);
}

TEST(CameraTracking, RecoversSmallMotions) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const Eigen::Isometry3d from = around_table(0.4);
  for (int trial = 0; trial < 12; ++trial) {
    const Eigen::Vector3d turn(uniform(random), uniform(random), uniform(random));
    const Eigen::Vector3d shift(uniform(random), uniform(random), uniform(random));
    const Eigen::Isometry3d to = from * motion(0.015 * turn, 0.01 * shift);
    const TrackingResult result = track(tabletop(), from, to);
    EXPECT_EQ(result.status, TrackingStatus::converged) << result.reason;
    expect_pose(result.T_world_camera, to);
    EXPECT_GT(result.overlap, 0.6);
    EXPECT_LE(result.overlap, 1.0);
    EXPECT_GT(result.inliers, 0.8);
    EXPECT_LT(result.residual, 1e-3);
    EXPECT_TRUE(result.unconstrained.empty());
  }
}

TEST(CameraTracking, KeepsThePoseOfAStaticCamera) {
  const Eigen::Isometry3d pose = around_table(1.0);
  const TrackingResult result = track(tabletop(), pose, pose);
  EXPECT_EQ(result.status, TrackingStatus::converged);
  expect_pose(result.T_world_camera, pose, 1e-5, 1e-5);
  EXPECT_GT(result.overlap, 0.95);
}

TEST(CameraTracking, KeepsRotationsOrthonormal) {
  Eigen::Isometry3d pose = around_table(0.0);
  for (int k = 1; k <= 20; ++k) {
    const Eigen::Isometry3d to = around_table(0.02 * k);
    pose = track_camera(measure(tabletop(), to),
                        exact_view(tabletop(), around_table(0.02 * k - 0.02), pose), pose, {}, {})
               .T_world_camera;
    const Eigen::Matrix3d R = pose.linear();
    EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-13);
  }
}

TEST(CameraTracking, IsEquivariantUnderRigidMotion) {
  std::mt19937 random(11);
  const Eigen::Isometry3d from = around_table(0.4);
  const Eigen::Isometry3d to = from * motion({0.01, -0.02, 0.015}, {0.01, 0.005, -0.01});
  const Measurement measurement = measure(tabletop(), to);
  const TrackingResult here =
      track_camera(measurement, exact_view(tabletop(), from, from), from, {}, {});
  for (int trial = 0; trial < 5; ++trial) {
    const Eigen::Isometry3d T = random_pose(random, 2.0);
    const TrackingResult there =
        track_camera(measurement, exact_view(tabletop(), from, T * from), T * from, {}, {});
    EXPECT_EQ(there.status, here.status);
    expect_pose(there.T_world_camera, T * here.T_world_camera, 1e-6, 1e-6);
    EXPECT_NEAR(there.residual, here.residual, 1e-6);
  }
}

/// A depth image with noise in proportion to the squared depth (Khoshelham and Elberink 2012).
DepthFrame with_noise(DepthFrame frame, std::mt19937& random) {
  std::normal_distribution<float> noise(0.0F, 1.425e-3F);
  for (float& z : frame.depth) z += noise(random) * z * z;
  return frame;
}

TEST(CameraTracking, FollowsAStepAroundATableTwoMetresAway) {
  const CameraIntrinsics camera{320, 240, 262.5, 262.5, 159.5, 119.5};
  const auto around = [](double angle) {
    return look_at({1.5 * std::cos(angle), 1.5 * std::sin(angle), 1.3}, {0.0, 0.0, 0.0});
  };
  std::mt19937 random(7);
  std::vector<double> errors;  // the camera moves by 5 cm
  for (int k = 0; k < 7; ++k) {
    const Eigen::Isometry3d from = around(0.9 * k), to = around(0.9 * k + radians(2.0));
    const DepthFrame first = with_noise(render(tabletop(), camera, from), random);
    const DepthFrame second = with_noise(render(tabletop(), camera, to), random);
    const ModelView view{find_surface(first.depth, camera, {}), from};
    const TrackingResult found =
        track_camera(prepare_measurement(second, camera, {}), view, from, {}, {});
    errors.push_back((found.T_world_camera.translation() - to.translation()).norm());
  }
  // The noise of the table's normals would hold the camera back where it was.
  std::ranges::sort(errors);
  EXPECT_LT(errors[3], 0.008);
  EXPECT_LT(errors[5], 0.02);
}

std::string all_motions(const TrackingResult& result) {
  std::string all;
  for (const std::string& motion : result.unconstrained) all += motion + "; ";
  return all;
}

void expect_free(const TrackingResult& result, const std::set<std::string>& motions) {
  EXPECT_EQ(result.status, TrackingStatus::degenerate) << result.reason;
  EXPECT_EQ(result.unconstrained.size(), motions.size()) << all_motions(result);
  for (const char* name : {"rotation about x", "rotation about y", "rotation about z",
                           "translation along x", "translation along y", "translation along z"}) {
    EXPECT_EQ(all_motions(result).find(name) != std::string::npos, motions.contains(name))
        << name << " in " << all_motions(result);
  }
}

TEST(CameraTracking, NamesTheMotionsThatAPlaneLeavesFree) {
  const Bodies wall{plane(-Eigen::Vector3d::UnitZ(), 0.8)};
  const Eigen::Isometry3d from = Eigen::Isometry3d::Identity();
  const TrackingResult result = track(wall, from, motion({0, 0, 0.02}, {0.01, -0.01, 0.004}));
  expect_free(result, {"translation along x", "translation along y", "rotation about z"});
  // Along the free motions it stays at the guess; the others it finds.
  expect_pose(result.T_world_camera, motion({0, 0, 0}, {0, 0, 0.004}), 2e-4, 1e-3);
}

TEST(CameraTracking, NamesTheRotationsThatABallLeavesFree) {
  const Bodies ball{sphere({0, 0, 0.8}, 0.3)};
  const TrackingResult result =
      track(ball, Eigen::Isometry3d::Identity(), motion({0, 0, 0.01}, {0.004, 0.002, 0.003}));
  EXPECT_EQ(result.status, TrackingStatus::degenerate) << result.reason;
  EXPECT_EQ(result.unconstrained.size(), 3U) << all_motions(result);
  const std::string all = all_motions(result);
  for (const char* name : {"rotation about x", "rotation about y", "rotation about z"}) {
    EXPECT_NE(all.find(name), std::string::npos) << all;
  }
}

TEST(CameraTracking, IsConstrainedByThreeWalls) {
  const Bodies corner{plane(Eigen::Vector3d(-1, 0, -1).normalized(), 0.7),
                      plane(Eigen::Vector3d(1, 0, -1).normalized(), 0.7),
                      plane(Eigen::Vector3d(0, -1, -0.6).normalized(), 0.5)};
  const Eigen::Isometry3d to = motion({0.01, 0.02, -0.01}, {0.01, -0.01, 0.01});
  const TrackingResult result = track(corner, Eigen::Isometry3d::Identity(), to);
  EXPECT_EQ(result.status, TrackingStatus::converged) << all_motions(result);
  expect_pose(result.T_world_camera, to);
}

TEST(CameraTracking, IsLostWithoutAnImageOrAModel) {
  const Eigen::Isometry3d pose = around_table(0.0);
  const DepthFrame black = flat_frame(small_camera(), 0.0F);
  const ModelView view = exact_view(tabletop(), pose, pose);
  const TrackingResult dark =
      track_camera(prepare_measurement(black, small_camera(), {}), view, pose, {}, {});
  EXPECT_EQ(dark.status, TrackingStatus::lost);
  EXPECT_STRNE(dark.reason, "");
  EXPECT_FALSE(dark.searchable);
  const ModelView nothing{{small_camera(), std::vector<SurfacePixel>(small_camera().pixels())},
                          pose};
  const TrackingResult alone = track_camera(measure(tabletop(), pose), nothing, pose, {}, {});
  EXPECT_EQ(alone.status, TrackingStatus::lost);
  EXPECT_STRNE(alone.reason, "");
  EXPECT_TRUE(alone.searchable);
}

TEST(CameraTracking, IsLostInAnotherScene) {
  const Eigen::Isometry3d pose = around_table(0.0);
  const ModelView view = exact_view(tabletop(), pose, pose);
  const std::vector<Bodies> others{
      {plane(-Eigen::Vector3d::UnitZ(), 2.0)},
      {sphere({0, 0, 1.0}, 0.3)},
      {plane(Eigen::Vector3d(1, 0, -1).normalized(), 1.2), sphere({0.1, 0.1, 0.5}, 0.1)}};
  for (const Bodies& other : others) {
    const Measurement measurement = measure(other, Eigen::Isometry3d::Identity());
    const TrackingResult result = track_camera(measurement, view, pose, {}, {});
    EXPECT_EQ(result.status, TrackingStatus::lost);
    EXPECT_STRNE(result.reason, "");
  }
}

TEST(CameraTracking, IsLostIfTheCameraWouldHaveJumped) {
  const Eigen::Isometry3d from = around_table(0.4), to = from * motion({0, 0, 0}, {0.02, 0, 0});
  TrackingOptions options;
  options.max_translation = 0.01;
  const TrackingResult result =
      track_camera(measure(tabletop(), to), exact_view(tabletop(), from, from), from, options, {});
  EXPECT_EQ(result.status, TrackingStatus::lost);
  EXPECT_STREQ(result.reason, "the camera would have jumped");
}

TEST(CameraTracking, AlwaysReturnsAFinitePose) {
  std::mt19937 random(17);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Isometry3d from = random_pose(random, 0.7), to = random_pose(random, 0.7);
    const TrackingResult result = track(tabletop(), from, to);
    EXPECT_TRUE(result.T_world_camera.matrix().allFinite());
    EXPECT_TRUE(std::isfinite(result.overlap + result.inliers + result.residual));
    if (result.status == TrackingStatus::lost) {
      EXPECT_STRNE(result.reason, "");
    }
  }
  const Eigen::Isometry3d pose = around_table(0.0);
  Eigen::Isometry3d no_pose = pose;
  no_pose.translation().x() = std::numeric_limits<double>::quiet_NaN();
  const ModelView view = exact_view(tabletop(), pose, pose);
  EXPECT_EQ(track_camera(measure(tabletop(), pose), view, no_pose, {}, {}).status,
            TrackingStatus::lost);
}

TEST(CameraTracking, WorksOnTinyImages) {
  for (const Index size : {8U, 9U, 13U, 24U}) {
    const CameraIntrinsics camera{
        size, size, 1.0 * size, 1.0 * size, 0.5 * (size - 1), 0.5 * (size - 1)};
    const Eigen::Isometry3d pose = around_table(0.0);
    const DepthFrame frame = render(tabletop(), camera, pose);
    const ModelView view{find_surface(frame.depth, camera, {}), pose};
    const TrackingResult result =
        track_camera(prepare_measurement(frame, camera, {}), view, pose, {}, {});
    EXPECT_TRUE(result.T_world_camera.matrix().allFinite());
    if (result.status != TrackingStatus::lost) {
      expect_pose(result.T_world_camera, pose, 1e-4, 1e-4);
    }
  }
}

TEST(CameraTracking, IsTheSameForAnyNumberOfThreads) {
  const Eigen::Isometry3d from = around_table(0.4);
  const Measurement measurement =
      measure(tabletop(), from * motion({0.01, 0.02, 0.0}, {0.01, 0, 0.01}));
  const ModelView view = exact_view(tabletop(), from, from);
  const auto run = [&] { return track_camera(measurement, view, from, {}, {}); };
  const TrackingResult one = with_threads(1, run);
  for (const std::size_t threads : {2U, 4U}) {
    const TrackingResult more = with_threads(threads, run);
    EXPECT_EQ(more.T_world_camera.matrix(), one.T_world_camera.matrix());
    EXPECT_EQ(more.residual, one.residual);
  }
}

}  // namespace
}  // namespace symscene
