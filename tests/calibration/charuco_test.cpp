#include "symscene/calibration/charuco.hpp"

#include <gtest/gtest.h>

#include "calibration/simulated_charuco.hpp"
#include "symscene/core/error.hpp"

namespace symscene {
namespace {

using namespace calibration_test;

#define SKIP_WITHOUT_ARUCO() \
  if (!has_charuco()) GTEST_SKIP() << "OpenCV's module aruco is not in this build"

CharucoView view_of(const CharucoBoard& drawn, const CharucoBoard& said,
                    const Eigen::Isometry3d& T_camera_board) {
  const CameraModel camera = charuco_camera();
  return find_charuco(rendered_charuco(camera, drawn, T_camera_board), camera.intrinsics.width,
                      camera.intrinsics.height, said);
}

void expect_true_corners(const CharucoView& view, const Eigen::Isometry3d& T_camera_board) {
  for (std::size_t i = 0; i < view.image.corners.size(); ++i) {
    const Eigen::Vector3d corner = the_charuco().board.corner(view.image.number(i));
    EXPECT_LT((view.image.corners[i] - shown_at(charuco_camera(), T_camera_board * corner)).norm(),
              0.5);
  }
}

TEST(FindCharuco, FindsTheCornersOfABoardInViewToAFractionOfAPixel) {
  SKIP_WITHOUT_ARUCO();
  Random random(1);
  for (int i = 0; i < 4; ++i) {
    const auto pose = random_board_pose(charuco_camera(), the_charuco().board, random);
    const CharucoView view = view_of(the_charuco(), the_charuco(), pose);
    ASSERT_TRUE(view.is_found()) << view.reason;
    EXPECT_GE(view.image.corners.size(), 20U);  // of 30
    expect_true_corners(view, pose);
  }
}

TEST(FindCharuco, NumbersTheCornersOfAPartOfABoardAsTheBoardDoes) {
  SKIP_WITHOUT_ARUCO();
  Random random(2);
  for (const double shift : {-0.08, 0.06}) {
    auto pose = random_board_pose(charuco_camera(), the_charuco().board, random);
    pose.translation().z() = 0.35;
    pose.translation().x() += shift;
    const CharucoView view = view_of(the_charuco(), the_charuco(), pose);
    ASSERT_TRUE(view.is_found()) << view.reason;
    EXPECT_LT(view.image.corners.size(), the_charuco().board.corners() - 4);
    expect_true_corners(view, pose);
  }
}

TEST(FindCharuco, RefusesBoardsThatAreNotAsSaidAndTellsWhy) {
  SKIP_WITHOUT_ARUCO();
  Random random(3);
  const auto pose = random_board_pose(charuco_camera(), the_charuco().board, random);
  const auto reason = [&](CharucoBoard said) { return view_of(the_charuco(), said, pose).reason; };
  CharucoBoard said = the_charuco();
  said.board.columns = 7;
  EXPECT_NE(reason(said).find("7x5"), std::string::npos) << reason(said);
  said.board.columns = 5;
  EXPECT_NE(reason(said).find("those up to"), std::string::npos) << reason(said);
  said = the_charuco();
  said.marker = 0.015;
  EXPECT_NE(reason(said).find("markers of about 2"), std::string::npos) << reason(said);
  said = the_charuco();
  said.dictionary = "DICT_6X6_50";
  EXPECT_NE(reason(said).find("0 markers"), std::string::npos) << reason(said);
}

TEST(FindOtherDictionary, NamesTheOneOfTheMarkers) {
  SKIP_WITHOUT_ARUCO();
  Random random(4);
  const CameraModel camera = charuco_camera();
  const auto pose = random_board_pose(camera, the_charuco().board, random);
  const auto grey = rendered_charuco(camera, the_charuco(), pose);
  const auto& [width, height] = std::pair(camera.intrinsics.width, camera.intrinsics.height);
  EXPECT_EQ(find_other_dictionary(grey, width, height, "DICT_4X4_50"), the_charuco().dictionary);
  const std::vector<std::uint8_t> blank(grey.size(), 120);
  EXPECT_EQ(find_other_dictionary(blank, width, height, "DICT_4X4_50"), "");
}

TEST(CalibrateIntrinsics, FindsTheCameraByPartsOfABoard) {
  if (!has_board_calibration()) GTEST_SKIP() << "OpenCV is not in this build";
  // Each image shows another part of the board.
  auto images = board_images(true_camera(), the_board(), 15, 0.1, 5);
  Random random(6);
  for (BoardImage& image : images) {
    const BoardImage whole = image;
    image.corners.clear();
    const auto first = static_cast<std::size_t>(random.uniform(0.0, 3.99));
    for (std::size_t i = 0; i < whole.corners.size(); ++i) {
      if (i % 8 < first || i % 8 >= first + 5) continue;
      image.corners.push_back(whole.corners[i]);
      image.numbers.push_back(i);
    }
  }
  const IntrinsicCalibration found = calibrate_intrinsics(images, 640, 480, the_board());
  EXPECT_NEAR(found.camera.intrinsics.fx / true_camera().intrinsics.fx, 1.0, 0.005);
  EXPECT_NEAR(found.camera.intrinsics.cx, true_camera().intrinsics.cx, 3.0);
  EXPECT_LT(found.error, 0.15);
  images[2].numbers[0] = the_board().corners();
  EXPECT_THROW(calibrate_intrinsics(images, 640, 480, the_board()), InputError);
}

TEST(CalibrateColorPose, UsesTheCornersThatBothImagesOfAPairShow) {
  if (!has_board_calibration()) GTEST_SKIP() << "OpenCV is not in this build";
  Eigen::Isometry3d T_depth_color = Eigen::Isometry3d::Identity();
  T_depth_color.translation().x() = 0.025;
  std::vector<BoardImage> first, second;
  Random random(7);
  const auto part = [](const BoardImage& whole, std::size_t begin, std::size_t end) {
    BoardImage image;
    for (std::size_t i = begin; i < end; ++i) {
      image.corners.push_back(whole.corners[i]);
      image.numbers.push_back(i);
    }
    return image;
  };
  for (int i = 0; i < 10; ++i) {
    const auto pose = random_board_pose(true_camera(), the_board(), random);
    const auto beside = T_depth_color.inverse() * pose;
    first.push_back(
        part(board_image(true_camera(), the_board(), pose, 0.05, random.seed()), 0, 40));
    second.push_back(
        part(board_image(true_camera(), the_board(), beside, 0.05, random.seed()), 8, 48));
  }
  const ColorPose found =
      calibrate_color_pose(first, second, true_camera(), true_camera(), the_board());
  EXPECT_EQ(found.pairs, 10U);
  EXPECT_LT((found.T_depth_color.translation() - T_depth_color.translation()).norm(), 0.001);
}

TEST(BoardPose, IsThatOfTheBoardByAPartOfIt) {
  if (!has_board_calibration()) GTEST_SKIP() << "OpenCV is not in this build";
  Random random(8);
  const auto pose = random_board_pose(true_camera(), the_board(), random);
  BoardImage image = board_image(true_camera(), the_board(), pose, 0.0, 1);
  image.corners.erase(image.corners.begin(), image.corners.begin() + 20);
  for (std::size_t i = 20; i < the_board().corners(); ++i) image.numbers.push_back(i);
  const auto found = board_pose(image, true_camera(), the_board());
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->isApprox(pose, 1e-4));
}

TEST(CharucoBoard, RefusesWhatCannotBePrinted) {
  CharucoBoard board = the_charuco();
  EXPECT_NO_THROW(board.validate());
  board.marker = board.board.square;
  EXPECT_THROW(board.validate(), InputError);
  board = the_charuco();
  board.dictionary = "DICT_8X8_50";
  EXPECT_THROW(board.validate(), InputError);
  board = the_charuco();
  board.board = {20, 20, 0.03};
  EXPECT_THROW(board.validate(), InputError);
}

TEST(CharucoBoard, WithoutOpenCvsModuleTheErrorNamesThePackage) {
  if (has_charuco()) GTEST_SKIP() << "this build has it";
  try {
    find_charuco({}, 0, 0, the_charuco());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.expected().find("libopencv-contrib-dev"), std::string::npos);
  }
}

}  // namespace
}  // namespace symscene
