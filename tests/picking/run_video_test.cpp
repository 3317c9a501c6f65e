#include "symscene/picking/run_video.hpp"

#include <gtest/gtest.h>

#include <set>

#include "gif_frames.hpp"
#include "picking/video_camera.hpp"
#include "symscene/core/error.hpp"
#include "symscene/core/thread_limit.hpp"
#include "viewer/recorded_run.hpp"

namespace symscene {
namespace {

TEST(RunVideo, TheCameraSeesTheRobotAtAllMoments) {
  const RunRecording run = carried_box();
  for (const auto& [width, height] : {std::pair{480, 360}, {360, 480}, {1000, 100}}) {
    RunVideoOptions options;
    options.width = width;
    options.height = height;
    const VideoCamera camera = video_camera(run, options);
    const Eigen::Isometry3d T_camera_table = camera.T_table_camera.inverse();
    for (const std::vector<Eigen::Isometry3d>& poses : run.poses) {
      for (std::size_t k = 0; k < run.solids.size(); ++k) {
        if (run.solids[k].kind == RecordedKind::object) continue;
        for (Eigen::Index i = 0; i < run.solids[k].mesh.vertices.rows(); ++i) {
          const Eigen::Vector3d vertex =
              run.solids[k].mesh.vertices.row(i).transpose().cast<double>();
          const Eigen::Vector3d point = T_camera_table * poses[k] * vertex;
          ASSERT_GT(point.z(), 0.0);
          const Eigen::Vector2d pixel = camera.intrinsics.project(point);
          EXPECT_GE(pixel.minCoeff(), -0.5);
          EXPECT_LE(pixel.x(), width - 0.5);
          EXPECT_LE(pixel.y(), height - 0.5);
        }
      }
    }
  }
}

#ifdef SYMSCENE_HAS_GIF

RunVideoOptions small_video() {
  RunVideoOptions options;
  options.width = 120;
  options.height = 90;
  return options;
}

std::vector<testing::GifFrame> frames_of(const RunRecording& run, const RunVideoOptions& options) {
  return testing::gif_frames(render_run_video(run, options));
}

TEST(RunVideo, ShowsTheMotionAtItsOwnSpeed) {
  const std::vector<testing::GifFrame> frames = frames_of(carried_box(), small_video());
  ASSERT_EQ(frames.size(), 41U);  // 4 s
  std::set<std::vector<unsigned char>> distinct;
  int delays = 0;
  for (const testing::GifFrame& frame : frames) {
    EXPECT_EQ(frame.width, 120);
    EXPECT_EQ(frame.height, 90);
    distinct.insert(frame.colors);
    delays += frame.delay;
  }
  EXPECT_EQ(distinct.size(), frames.size());
  EXPECT_EQ(delays, 410 + 200);
}

TEST(RunVideo, LongRunsAreSpedUp) {
  RunVideoOptions options = small_video();
  options.max_duration = 1.0;
  const std::vector<testing::GifFrame> all = frames_of(carried_box(), small_video());
  const std::vector<testing::GifFrame> fast = frames_of(carried_box(), options);
  ASSERT_EQ(fast.size(), 11U);
  EXPECT_EQ(fast.front().colors, all.front().colors);
  EXPECT_EQ(fast.back().colors, all.back().colors);
}

TEST(RunVideo, AMomentIsShownOnceWhereNothingMoves) {
  RunRecording run = carried_box(2);
  run.times.resize(1);
  run.poses.resize(1);
  EXPECT_EQ(frames_of(run, small_video()).size(), 1U);
}

TEST(RunVideo, IsTheSameForAnyNumberOfThreads) {
  const auto render = [](std::size_t threads) {
    const ThreadLimit limit(threads);
    return render_run_video(carried_box(5), small_video());
  };
  EXPECT_EQ(render(1), render(3));
}

TEST(RunVideo, RefusesWhatCannotBeDrawn) {
  EXPECT_THROW(render_run_video({}), InputError);
  RunRecording run = carried_box();
  run.poses[3].pop_back();
  EXPECT_THROW(render_run_video(run), InputError);
  RunVideoOptions options = small_video();
  options.width = 1;
  EXPECT_THROW(render_run_video(carried_box(), options), InputError);
}

#endif

}  // namespace
}  // namespace symscene
