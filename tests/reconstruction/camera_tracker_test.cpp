#include "reconstruction/camera_tracker.hpp"

#include <gtest/gtest.h>

#include "reconstruction/analytic_scenes.hpp"

namespace symscene {
namespace {

using namespace symscene::testing;

TrackingResult known(const Eigen::Isometry3d& T_world_camera) {
  TrackingResult result;
  result.status = TrackingStatus::converged;
  result.T_world_camera = T_world_camera;
  result.agreement = 1.0;
  return result;
}

/// The frame without all but a strip of its left side.
DepthFrame left_strip(DepthFrame frame, const CameraIntrinsics& camera) {
  for (std::size_t i = 0; i < frame.depth.size(); ++i) {
    if (i % camera.width > camera.width / 5) frame.depth[i] = 0.0F;
  }
  return frame;
}

TEST(CameraTracker, FollowsTheLastFrameWhereTheModelShowsNothing) {
  const CameraIntrinsics camera = small_camera();
  const auto measure = [&](const DepthFrame& frame) {
    return prepare_measurement(frame, camera, {});
  };
  const DepthFrame first = render(tabletop(), camera, around_table(0.0));
  TsdfVolume volume;
  volume.integrate(measure(left_strip(first, camera)), around_table(0.0));
  StageClock clock;
  CameraTracker tracker(volume, {}, {}, clock);
  tracker.accept(measure(first), known(around_table(0.0)), false);
  const CameraTracker::Located located =
      tracker.locate(measure(render(tabletop(), camera, around_table(0.03))), std::nullopt);
  ASSERT_EQ(located.tracking.status, TrackingStatus::converged) << located.tracking.reason;
  EXPECT_FALSE(located.relocalized);
  const Eigen::Isometry3d error = around_table(0.03).inverse() * located.tracking.T_world_camera;
  EXPECT_LT(error.translation().norm(), 0.003);
  EXPECT_LT(Eigen::AngleAxisd(error.linear()).angle(), radians(0.3));
}

}  // namespace
}  // namespace symscene
