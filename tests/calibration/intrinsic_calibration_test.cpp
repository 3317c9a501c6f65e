#include "symscene/calibration/intrinsic_calibration.hpp"

#include <gtest/gtest.h>

#include "calibration/simulated_boards.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using namespace calibration_test;

#define SKIP_WITHOUT_OPENCV() \
  if (!has_board_calibration()) GTEST_SKIP() << "OpenCV is not in this build"

TEST(CalibrateIntrinsics, FindsTheCameraWithATenthOfAPixelOfNoise) {
  SKIP_WITHOUT_OPENCV();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto images = board_images(true_camera(), the_board(), 15, 0.1, seed);
    const IntrinsicCalibration found = calibrate_intrinsics(images, 640, 480, the_board());
    const CameraIntrinsics& K = found.camera.intrinsics;
    EXPECT_NEAR(K.fx / true_camera().intrinsics.fx, 1.0, 0.002);
    EXPECT_NEAR(K.fy / true_camera().intrinsics.fy, 1.0, 0.002);
    EXPECT_NEAR(K.cx, true_camera().intrinsics.cx, 1.5);
    EXPECT_NEAR(K.cy, true_camera().intrinsics.cy, 1.5);
    EXPECT_LT(found.error, 0.15);
    EXPECT_NEAR(found.camera.distortion.k1, true_camera().distortion.k1, 0.02);
  }
}

TEST(CalibrateIntrinsics, DoesNotDependOnTheSizeOfTheSquares) {
  SKIP_WITHOUT_OPENCV();
  const auto images = board_images(true_camera(), the_board(), 10, 0.1, 4);
  Board twice = the_board();
  twice.square *= 2.0;
  const double fx = calibrate_intrinsics(images, 640, 480, the_board()).camera.intrinsics.fx;
  EXPECT_NEAR(calibrate_intrinsics(images, 640, 480, twice).camera.intrinsics.fx, fx, 1e-3);
}

TEST(CalibrateIntrinsics, LeavesOutABadImageAndNamesIt) {
  SKIP_WITHOUT_OPENCV();
  auto images = board_images(true_camera(), the_board(), 12, 0.1, 5);
  for (std::size_t i = 0; i < images[3].corners.size(); i += 2) images[3].corners[i].x() += 4.0;
  const IntrinsicCalibration found = calibrate_intrinsics(images, 640, 480, the_board());
  EXPECT_FALSE(found.views[3].used);
  EXPECT_FALSE(found.views[3].reason.empty());
  EXPECT_LT(found.error, 0.15);
}

TEST(CalibrateIntrinsics, RefusesTooFewImagesAndBoardsParallelToTheImage) {
  SKIP_WITHOUT_OPENCV();
  const auto images = board_images(true_camera(), the_board(), 3, 0.1, 6);
  EXPECT_THROW(calibrate_intrinsics(images, 640, 480, the_board()), InputError);
  std::vector<BoardImage> parallel;
  for (int i = 0; i < 6; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() << -0.1 + 0.01 * i, -0.07, 0.6 + 0.02 * i;
    parallel.push_back(board_image(true_camera(), the_board(), pose, 0.1, 7));
  }
  EXPECT_THROW(calibrate_intrinsics(parallel, 640, 480, the_board()), InputError);
}

TEST(BoardPose, IsThatOfTheBoard) {
  SKIP_WITHOUT_OPENCV();
  Random random(8);
  for (int i = 0; i < 5; ++i) {
    const Eigen::Isometry3d pose = random_board_pose(true_camera(), the_board(), random);
    const auto found = board_pose(board_image(true_camera(), the_board(), pose, 0.0, 1),
                                  true_camera(), the_board());
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->isApprox(pose, 1e-4));
  }
}

TEST(CalibrateColorPose, FindsThePoseOfTheColourCamera) {
  SKIP_WITHOUT_OPENCV();
  CameraModel color = true_camera();
  color.intrinsics.fx = color.intrinsics.fy = 610.0;
  Eigen::Isometry3d T_depth_color(Eigen::AngleAxisd(0.02, Eigen::Vector3d(1, 2, 0.5).normalized()));
  T_depth_color.translation() << 0.025, 0.001, -0.002;
  std::vector<BoardImage> first, second;
  Random random(9);
  for (int i = 0; i < 12; ++i) {
    const Eigen::Isometry3d pose = random_board_pose(true_camera(), the_board(), random);
    first.push_back(board_image(true_camera(), the_board(), pose, 0.1, random.seed()));
    second.push_back(
        board_image(color, the_board(), T_depth_color.inverse() * pose, 0.1, random.seed()));
  }
  const ColorPose found = calibrate_color_pose(first, second, true_camera(), color, the_board());
  EXPECT_LT((found.T_depth_color.translation() - T_depth_color.translation()).norm(), 0.001);
  const Eigen::AngleAxisd between(found.T_depth_color.linear().transpose() *
                                  T_depth_color.linear());
  EXPECT_LT(degrees(std::abs(between.angle())), 0.1);
}

TEST(FindBoard, FindsRenderedCornersToAFractionOfAPixel) {
  SKIP_WITHOUT_OPENCV();
  Random random(10);
  const Eigen::Isometry3d pose = random_board_pose(small_board_camera(), the_board(), random);
  const std::vector<std::uint8_t> grey = rendered_board(small_board_camera(), the_board(), pose);
  auto found = find_board(grey, 320, 240, the_board());
  ASSERT_TRUE(found);
  const auto truth = board_image(small_board_camera(), the_board(), pose, 0.0, 1).corners;
  // A board looks the same from its other end.
  if ((found->front() - truth.front()).norm() > 10.0) std::reverse(found->begin(), found->end());
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_LT(((*found)[i] - truth[i]).norm(), 0.3);
  EXPECT_FALSE(find_board(std::vector<std::uint8_t>(320 * 240, 90), 320, 240, the_board()));
}

TEST(FindBoard, NamesABoardOfAnotherSize) {
  SKIP_WITHOUT_OPENCV();
  Random random(11);
  const Eigen::Isometry3d pose = random_board_pose(small_board_camera(), the_board(), random);
  const std::vector<std::uint8_t> grey = rendered_board(small_board_camera(), the_board(), pose);
  const Board wrong{9, 5, 0.03};
  const auto other = find_other_board(grey, 320, 240, wrong);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->columns * other->rows, 48);
  EXPECT_FALSE(find_other_board(grey, 320, 240, the_board()));
}

TEST(Board, RefusesOtherThanBoards) {
  EXPECT_THROW((Board{2, 6, 0.02}).validate(), InputError);
  EXPECT_THROW((Board{8, 6, 0.0}).validate(), InputError);
}

}  // namespace
}  // namespace symscene
