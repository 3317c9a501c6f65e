// `symscene calibrate`, run as a process.
#include "calibration/simulated_charuco.hpp"
#include "cli/small_scene.hpp"
#include "symscene/io/image.hpp"
#include "symscene/io/sequence.hpp"

namespace symscene::testing {
namespace {

#ifdef SYMSCENE_HAS_ROBOTS  // with yaml-cpp

using namespace calibration_test;

/// A grey image as PNG.
std::string png_of(const std::vector<std::uint8_t>& grey, ImageSize size) {
  ColorImage image{size, Colors(static_cast<Eigen::Index>(grey.size()), 3)};
  for (std::size_t i = 0; i < grey.size(); ++i)
    image.pixels.row(static_cast<Eigen::Index>(i)).setConstant(grey[i]);
  return format_png(image);
}

void write_boards(const fs::path& folder, int count) {
  fs::create_directories(folder);
  Random random(3);
  const CameraModel camera = small_board_camera();
  for (int i = 0; i < count; ++i) {
    const Eigen::Isometry3d pose = random_board_pose(camera, the_board(), random);
    write(folder / (std::to_string(i) + ".png"),
          png_of(rendered_board(camera, the_board(), pose), {320, 240}));
  }
}

void write_charuco_boards(const fs::path& folder, int count) {
  fs::create_directories(folder);
  Random random(4);
  const CameraModel camera = charuco_camera();
  for (int i = 0; i < count; ++i) {
    const Eigen::Isometry3d pose = random_board_pose(camera, the_charuco().board, random);
    write(folder / (std::to_string(i) + ".png"),
          png_of(rendered_charuco(camera, the_charuco(), pose), {480, 360}));
  }
}

/// Walls whose depth is off by 2 % at 2 m, more at the sides.
void write_walls(const fs::path& folder, double nearest, double farthest) {
  const CameraIntrinsics camera{160, 120, 131.0, 131.0, 79.5, 59.5};
  SequenceWriter writer(folder, camera);
  for (int i = 0; i < 6; ++i) {
    const double distance = nearest + (farthest - nearest) * i / 5.0;
    DepthFrame frame;
    frame.time = i;
    for (Index v = 0; v < camera.height; ++v) {
      for (Index u = 0; u < camera.width; ++u) {
        const Eigen::Vector3d ray = camera.ray(u, v);
        const double z = distance / (1.0 + 0.1 * (i % 3 - 1) * ray.x());
        frame.depth.push_back(
            static_cast<float>(z * (1.0 + 0.01 * z * (2.0 * ray.x() * ray.x() - 0.3))));
      }
    }
    writer.add(frame);
  }
  writer.finish();
}

double number_after(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  return at == std::string::npos ? 0.0 : std::stod(text.substr(at + word.size()));
}

TEST_F(Command, CalibratesIntrinsicsByImagesOfABoard) {
  write_boards(file("boards"), 7);
  const Outcome outcome = run(
      "calibrate intrinsics boards --board 8x6 --square 0.03 -o camera.yaml --page page.html -v");
  if (outcome.err.find("OpenCV") != std::string::npos) GTEST_SKIP() << outcome.err;
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(number_after(outcome.out, "fx "), 286.0, 3.0) << outcome.out;
  EXPECT_NE(contents(file("page.html")).find("</svg>"), std::string::npos);
  EXPECT_NE(outcome.out.find("find boards"), std::string::npos) << outcome.out;
  EXPECT_NE(contents(file("camera.yaml")).find("\"distortion\""), std::string::npos);
  expect_refusal("calibrate intrinsics boards --board 8x5 --square 0.03 -o new.yaml", 2,
                 "the board that the images show");
  write(file("boards/9.png"), png_of(std::vector<std::uint8_t>(64, 9), {8, 8}));
  expect_refusal("calibrate intrinsics boards --board 8x6 --square 0.03 -o new.yaml", 1,
                 "calibrate each resolution by itself");
  write_boards(file("few"), 2);
  expect_refusal("calibrate intrinsics few --board 8x6 --square 0.03 -o new.yaml", 1, "at least 4");
  EXPECT_FALSE(fs::exists(file("new.yaml")));
}

TEST_F(Command, CalibratesIntrinsicsByImagesOfACharucoBoard) {
  const std::string board = "--board 6x5 --square 0.03 -o charuco.yaml ";
  const std::string command = "calibrate intrinsics markers " + board;
  fs::create_directories(file("markers"));
  if (!has_charuco()) {
    write(file("markers/0.png"), png_of(std::vector<std::uint8_t>(64, 9), {8, 8}));
    expect_refusal(command + "--charuco DICT_5X5_50 --marker 0.022", 1, "install libopencv-");
    return;
  }
  write_charuco_boards(file("markers"), 6);
  const Outcome outcome = run(command + "--charuco DICT_5X5_50 --marker 0.022 --page page.html");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NEAR(number_after(outcome.out, "fx "), 429.0, 5.0) << outcome.out;
  EXPECT_NE(contents(file("page.html")).find("</svg>"), std::string::npos);
  fs::remove(file("charuco.yaml"));
  expect_refusal(command + "--charuco DICT_5X5_50 --marker 0.015", 2, "markers of about 2");
  expect_refusal(command + "--charuco DICT_6X6_50 --marker 0.022", 2,
                 "the markers that the images show, DICT_5X5_50");
  EXPECT_FALSE(fs::exists(file("charuco.yaml")));
}

TEST_F(Command, CalibratesDepthByWallsAndUsesIt) {
  write_walls(file("walls"), 0.6, 2.0);
  const Outcome outcome = run("calibrate depth walls --wall -o camera.yaml --page page.html");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_GT(number_after(outcome.out, "error "), 4.0 * number_after(outcome.out, "before, "))
      << outcome.out;
  EXPECT_NE(contents(file("page.html")).find("Correction by range"), std::string::npos);
  // An earlier correction is left out: the result is the same.
  const Outcome again = run("calibrate depth walls --wall --intrinsics camera.yaml -o again.yaml");
  EXPECT_EQ(contents(file("again.yaml")), contents(file("camera.yaml"))) << again.err;
  EXPECT_NE(run("info walls").out, "");
  write_walls(file("near"), 1.0, 1.05);
  expect_refusal("calibrate depth near --wall -o new.yaml", 1, "several distances");
  expect_refusal("calibrate depth walls --board 8x6 -o new.yaml", 2, "--square");
}

#endif

TEST_F(Command, RefusesBoardsThatAreNone) {
  expect_refusal("calibrate intrinsics nowhere --board 8 --square 0.03 -o new.yaml", 2,
                 "the number of inner corners, like 8x6");
  expect_refusal("calibrate intrinsics nowhere --board 8x6 -o new.yaml", 2,
                 "the edge of a square in metres");
  expect_refusal("calibrate intrinsics nowhere --board 8x2 --square 0.03 -o new.yaml", 2,
                 "corners along each edge");
  const std::string board = "calibrate intrinsics nowhere --board 8x6 --square 0.03 -o new.yaml ";
  expect_refusal(board + "--marker 0.02", 2, "--charuco");
  expect_refusal(board + "--charuco DICT_4X4_50", 2, "the edge of a marker in metres");
  expect_refusal(board + "--charuco DICT_4X4_50 --marker 0.04", 2, "that of a square, 0.03 m");
  expect_refusal(board + "--charuco DICT_8X8_50 --marker 0.02", 2, "--charuco");
  expect_refusal("calibrate", 2, "subcommand");
}

}  // namespace
}  // namespace symscene::testing
